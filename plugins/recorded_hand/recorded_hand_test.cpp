#include <stylet/contract/contract.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace stylet {
namespace {

using contract::Case;
using contract::Given;

constexpr double rounding = 1e-14;    // [m], [s] of values up to ten

const char* const header = "time [s],x [m],y [m],z [m],qw,qx,qy,qz\n";

Parameters insert(double distance, double speed) {
    return Given{{"insert", distance}, {"speed", speed}};
}
Parameters withdraw(double distance, double speed) {
    return Given{{"withdraw", distance}, {"speed", speed}};
}
Parameters hold(double time) {
    return Given{{"hold", time}};
}

/// The tip starts 2 mm above the surface, goes 10 mm in, waits and comes back.
Case in_and_out() {
    return {.name = "InAndOut",
            .parameters = {{"tip_start", Vector3(0.0, 0.0, 2e-3)},
                           {"motion", Parameters::Records{insert(10e-3, 10e-3), hold(0.5), withdraw(10e-3, 20e-3)}}}};
}

Case oblique() {
    Case with = in_and_out();
    with.name = "Oblique";
    with.parameters.set("direction", Vector3(3.0, 0.0, -4.0));
    with.parameters.set("cycles", std::int64_t{3});
    return with;
}

std::string example_file() {
    return std::filesystem::path(__FILE__).parent_path() / ".." / ".." / "scenes" / "hands" / "steady_10mm_s.csv";
}

Case from_file(const std::string& path) {
    return {.name = "File", .parameters = {{"file", path}}};
}

STYLET_CONTRACT(in_and_out(), oblique(), from_file(example_file()))

/// A file of its own for each process, since tests run side by side.
class PoseFile {
public:
    explicit PoseFile(const std::string& text) : path_(testing::TempDir() + "stylet_hand_" + std::to_string(getpid()) + ".csv") {
        std::ofstream(path_) << text;
    }
    PoseFile(const PoseFile&) = delete;
    PoseFile& operator=(const PoseFile&) = delete;
    ~PoseFile() { std::filesystem::remove(path_); }

    [[nodiscard]] const std::string& path() const { return path_; }

private:
    std::string path_;
};

std::unique_ptr<HapticDevice> hand(const Case& with) {
    return contract::make<HapticDevice>(STYLET_PLUGIN_FILE, with);
}

std::unique_ptr<HapticDevice> hand_of(const std::string& rows) {
    const PoseFile file(header + rows);
    return hand(from_file(file.path()));
}

std::string refusal(const Case& with, const std::string& key) {
    try {
        (void)hand(with);
    } catch (const Error& error) {
        EXPECT_EQ(error.key(), key);
        return error.what();
    }
    return "accepted";
}

std::string file_refusal(const std::string& text) {
    const PoseFile file(text);
    return refusal(from_file(file.path()), "file");
}

Vector3 tip(HapticDevice& device, double time) {
    const Pose pose = device.read(time).pose;
    return pose.position + contract::steel_needle().length * pose.axis();
}

TEST(RecordedHand, PlaysAMotionAtTheGivenSpeeds) {
    const auto device = hand(in_and_out());
    const std::pair<double, double> heights[] = {{0.0, 2e-3},   {0.5, -3e-3}, {1.0, -8e-3}, {1.3, -8e-3},
                                                 {1.75, -3e-3}, {2.0, 2e-3},  {9.0, 2e-3}};
    for (const auto& [time, height] : heights) {
        EXPECT_LE((tip(*device, time) - Vector3(0.0, 0.0, height)).norm(), rounding) << "at " << time << " s";
    }
    EXPECT_NEAR(device->duration(), 2.0, rounding);
}

TEST(RecordedHand, WithoutADirectionItIsNotTurnedAtAll) {
    EXPECT_EQ(hand(in_and_out())->read(0.7).pose.rotation.coeffs(), Quaternion::Identity().coeffs());
}

TEST(RecordedHand, AimsTheNeedleAlongTheDirection) {
    const auto device = hand(oblique());
    const Vector3 direction(0.6, 0.0, -0.8);
    EXPECT_LE((device->read(0.5).pose.axis() - direction).norm(), rounding);
    EXPECT_LE((device->read(0.5).pose.bow_direction() - Vector3(0.8, 0.0, 0.6)).norm(), rounding) << "the shortest turn, about y";
    EXPECT_LE((tip(*device, 0.5) - Vector3(0.0, 0.0, 2e-3) - 5e-3 * direction).norm(), rounding);
}

TEST(RecordedHand, PointsUpWhenAskedTo) {
    Case with = in_and_out();
    with.parameters.set("direction", Vector3(0.0, 0.0, 1.0));
    EXPECT_LE((hand(with)->read(0.0).pose.axis() - Vector3(0.0, 0.0, 1.0)).norm(), rounding);
}

TEST(RecordedHand, RepeatsItsCycles) {
    const auto device = hand(oblique());
    EXPECT_NEAR(device->duration(), 6.0, rounding);
    EXPECT_LE((tip(*device, 5.3) - tip(*device, 1.3)).norm(), rounding);
}

TEST(RecordedHand, FollowsTheExampleFile) {
    const auto device = hand(from_file(example_file()));
    EXPECT_LE((tip(*device, 0.0) - Vector3(0.0, 0.0, 2e-3)).norm(), rounding);
    EXPECT_LE((tip(*device, 5.0) - Vector3(0.0, 0.0, -48e-3)).norm(), rounding);
    EXPECT_EQ(device->duration(), 8.0);
}

TEST(RecordedHand, TurnsEvenlyBetweenRows) {
    const auto device = hand_of("1,0,0,0,1,0,0,0\n3,0,0,0.4,0.70710678,0.70710678,0,0\n");
    constexpr double file_digits = 1e-8;    // [rad] the quaternion has eight digits
    const Pose quarter = device->read(1.5).pose;
    EXPECT_NEAR(Eigen::AngleAxisd(Eigen::Quaterniond(quarter.rotation)).angle(), M_PI / 8.0, file_digits);
    EXPECT_NEAR(quarter.position.z(), 0.1, rounding);
    EXPECT_EQ(device->read(0.0).pose.position.z(), 0.0) << "the first row counts before its time";
}

TEST(RecordedHand, GoesItsWayWhateverItFeels) {
    const auto device = hand(in_and_out());
    const Vector3 before = tip(*device, 0.7);
    device->write({Vector3(1.0, 2.0, 8.0), Vector3(0.4, 0.5, 0.6)});
    EXPECT_EQ(tip(*device, 0.7), before);
}

TEST(RecordedHand, BearsWhatAPhantomPremiumDoes) {
    EXPECT_EQ(hand(in_and_out())->limits().force, 8.5);
}

TEST(RecordedHand, RefusesBadFilesWithTheirLine) {
    const std::string good = "0,0,0,0.2,1,0,0,0\n";
    const std::string wanted = "wanted the header \"time [s],x [m],y [m],z [m],qw,qx,qy,qz\"";
    EXPECT_EQ(file_refusal("# by hand\ntime,x\n"), "line 2: found \"time,x\", " + wanted);
    EXPECT_EQ(file_refusal(std::string(1000, 'x')), "line 1: found \"" + std::string(60, 'x') + "…\", " + wanted);
    EXPECT_EQ(file_refusal(""), "line 1: found nothing, " + wanted);
    EXPECT_EQ(file_refusal(header), "line 2: found no pose, wanted at least one");
    EXPECT_EQ(file_refusal(header + good + "1,0,0,0.2,1,0,0\n"), "line 3: found 7 columns, wanted the 8 of the header");
    EXPECT_EQ(file_refusal(header + good + "1,0,0,0.2,1,0,0,0,5\n"), "line 3: found 9 columns, wanted the 8 of the header");
    EXPECT_EQ(file_refusal(header + good + "1,0,zero,0.2,1,0,0,0\n"), "line 3: found \"zero\", wanted a finite number");
    EXPECT_EQ(file_refusal(header + good + "1,0,nan,0.2,1,0,0,0\n"), "line 3: found \"nan\", wanted a finite number");
    EXPECT_EQ(file_refusal(header + good + "\n"), "line 3: found an empty line, wanted a pose");
    EXPECT_EQ(file_refusal(header + good + "0,0,0,0.1,1,0,0,0\n"),
              "line 3: found a time that is not after the line before, wanted times that rise");
    EXPECT_EQ(file_refusal(std::string(header) + "-1,0,0,0.1,1,0,0,0\n"),
              "line 2: found a negative time, wanted times from 0 on");
    EXPECT_EQ(file_refusal(std::string(header) + "0,0,0,0.1,1,1,0,0\n"),
              "line 2: found a quaternion of length 1.414214, wanted one of length 1");
}

TEST(RecordedHand, RefusesAFileThatIsNotThere) {
    EXPECT_EQ(refusal(from_file("no/such/file.csv"), "file"), "cannot read \"no/such/file.csv\"");
}

TEST(RecordedHand, WantsAFileOrAMotion) {
    Case both = in_and_out();
    both.parameters.set("file", example_file());
    EXPECT_EQ(refusal(both, "motion"), "found both file and motion, wanted exactly one of them");
    EXPECT_EQ(refusal({}, ""), "found neither file nor motion, wanted exactly one of them");
    Case turned = from_file(example_file());
    turned.parameters.set("direction", Vector3(0.0, 0.0, -1.0));
    EXPECT_EQ(refusal(turned, "direction"), "belongs to a motion, and this hand follows a file");
}

TEST(RecordedHand, RefusesAMotionThatMakesNoSense) {
    const auto motion = [](Parameters::Records steps) {
        return Case{.parameters = {{"tip_start", Vector3(0.0, 0.0, 0.0)}, {"motion", std::move(steps)}}};
    };
    EXPECT_EQ(refusal(motion({}), "motion"), "found no step, wanted at least one");
    EXPECT_EQ(refusal(motion({insert(1e-3, 1e-3), Parameters()}), "motion"),
              "step 2: found 0 of insert, withdraw and hold, wanted exactly one");
    EXPECT_EQ(refusal(motion({Given{{"insert", 1e-3}, {"hold", 1.0}}}), "motion"),
              "step 1: found 2 of insert, withdraw and hold, wanted exactly one");
    EXPECT_EQ(refusal(motion({Given{{"withdraw", 1e-3}}}), "motion"),
              "step 1: found no speed, wanted one beside insert or withdraw");
    EXPECT_EQ(refusal(motion({Given{{"hold", 1.0}, {"speed", 1e-3}}}), "motion"),
              "step 1: found a speed beside hold, wanted hold alone");
    EXPECT_EQ(refusal({.parameters = {{"motion", Parameters::Records{hold(1.0)}}}}, "motion"),
              "found no tip_start, wanted where the tip is at time 0");
    Case lost = motion({hold(1.0)});
    lost.parameters.set("direction", Vector3(0.0, 0.0, 0.0));
    EXPECT_EQ(refusal(lost, "direction"), "found a vector of no length, wanted the direction of insertion");
}

}    // namespace
}    // namespace stylet
