// A needle alone in air, under an end load or against a pin, beside Euler's load and the paper's Eqs. (4) and (5).
#include "tests/whole_scenes/mapped_plugins.h"
#include "tests/whole_scenes/trace.h"

#include <stylet/contract/allocations.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/tools/roots.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace stylet::whole_scenes {
namespace {

using std::numbers::pi;

constexpr double published = 0.01;    // relative: the bound for a critical load
constexpr double tabulated =
    1e-6;                         // relative: the column's curve is a table (its own test: 1e-9), and a tip's way magnifies it
constexpr double books = 1e-6;    // of the peak work: the bound
constexpr double gives = 1e-9;    // [m/N] what core lets it that holds a tip
constexpr double length = 0.2;    // [m]
const double stiffness = 200e9 * pi * std::pow(0.3e-3, 4) / 4.0;                                // [N·m²]
const double critical_load = std::pow(4.493409457909064, 2) * stiffness / (length * length);    // [N] clamped-pinned

/// A bowed column with this slope at its ends.
struct Bow {
    double slope;    // [rad]

    [[nodiscard]] double load() const {    // [N] Eq. (5)
        return critical_load * std::pow(2.0 * boost::math::ellint_1(std::sin(0.5 * slope)) / pi, 2);
    }
    [[nodiscard]] double shortening() const {    // [m] Eq. (4), inextensible
        return length * (1.0 - pi * std::cos(slope) / (2.0 * boost::math::ellint_2(std::sin(slope))));
    }
    [[nodiscard]] double amplitude() const {    // [m]
        return length * std::sin(slope) / (2.0 * boost::math::ellint_2(std::sin(slope)));
    }
};

/// The one for which a quantity that grows with the slope is what is wanted.
Bow bow_where(double (Bow::*quantity)() const, double wanted) {
    std::uintmax_t iterations = 100;
    const auto [low, high] =
        boost::math::tools::toms748_solve([&](double slope) { return (Bow{slope}.*quantity)() - wanted; }, 1e-6, 1.5,
                                          boost::math::tools::eps_tolerance<double>(50), iterations);
    return {0.5 * (low + high)};
}

double way_of_tip(const Stage& stage) {    // [m] up from where it was
    return stage.cast().needle().position(length).z();
}

TEST(NeedleAlone, BucklesUnderAnEndLoadAtEulersLoad) {
    const Trace trace = play(own_scene("column_in_air_end_load"));
    print_events(trace);
    const Happening* const buckled = trace.first("buckled");
    ASSERT_NE(buckled, nullptr);
    EXPECT_EQ(trace.events.size(), 1u);
    measured("buckled_at", buckled->hand_force, "N");
    EXPECT_NEAR(buckled->hand_force, critical_load, published * critical_load);
    for (const core::Sample& sample : trace.samples) {
        ASSERT_EQ(sample.deflection > 0.0, sample.hand_force > critical_load) << "at " << sample.time << " s";
    }
}

TEST(NeedleAlone, BowsUnderAnEndLoadAsTheColumnsCurveSays) {
    Stage stage(own_scene("column_in_air_end_load"));
    const Trace trace = play(stage);
    const Bow bow = bow_where(&Bow::load, 0.67);
    measured("bow", trace.samples.back().deflection, "m");
    measured("tip", way_of_tip(stage), "m");
    EXPECT_NEAR(trace.samples.back().hand_force, 0.67, tabulated);
    EXPECT_NEAR(trace.samples.back().deflection / bow.amplitude(), 1.0, tabulated);
    EXPECT_NEAR(way_of_tip(stage) / bow.shortening(), 1.0, tabulated);
}

TEST(NeedleAlone, StoresTheWorkOfAnEndLoad) {
    const Trace trace = play(own_scene("column_in_air_end_load"));
    measured("load_work", trace.samples.back().load_work, "J");
    measured("relative", trace.relative);
    EXPECT_GT(trace.samples.back().load_work, 0.0);
    EXPECT_EQ(trace.samples.back().hand_work, 0.0) << "nobody moves the base";
    expect_sound(trace, books);
}

TEST(NeedleAlone, BucklesAgainstAPinAtEulersLoad) {
    Stage stage(own_scene("column_in_air_pinned"));
    const Trace trace = play(stage);
    print_events(trace);
    const Happening* const buckled = trace.first("buckled");
    ASSERT_NE(buckled, nullptr);
    EXPECT_EQ(trace.events.size(), 1u);
    measured("buckled_at", buckled->hand_force, "N");
    EXPECT_NEAR(buckled->hand_force, critical_load, published * critical_load);

    const Bow bow = bow_where(&Bow::shortening, 4e-3);
    measured("force", trace.samples.back().hand_force, "N");
    measured("bow", trace.samples.back().deflection, "m");
    EXPECT_NEAR(trace.samples.back().hand_force / bow.load(), 1.0, tabulated);
    EXPECT_NEAR(trace.samples.back().deflection / bow.amplitude(), 1.0, tabulated);
    EXPECT_EQ(trace.samples.back().load_work, 0.0) << "what holds does no work";
}

TEST(NeedleAlone, LeansAgainstAPinThatNeitherGivesNorCreeps) {
    Stage stage(own_scene("column_in_air_pinned"));
    double most = 0.0;
    for (std::size_t tick = 0; tick < stage.ticks(); ++tick) {
        stage.simulation().tick();
        most = std::max(most, stage.cast().needle().position(length).norm());
    }
    measured("tip", most, "m");
    EXPECT_LE(most, 1.01 * critical_load * gives) << "bowed, it carries a hundredth more than its critical load";
}

// A column that doesn't shorten meets a rigid stop with all of its critical load at once. The trapezoid rule takes half of it for
// the first tick's way; nothing else is lost.
TEST(NeedleAlone, KeepsItsBooksAgainstAPinButForHalfTheJump) {
    constexpr double first_way = 2e-6;    // [m] 2 mm/s for a tick
    const Trace trace = play(own_scene("column_in_air_pinned"));
    const double half_the_jump = 0.5 * critical_load * first_way;
    measured("residual", trace.samples.back().residual, "J");
    measured("half_the_jump", half_the_jump, "J");
    EXPECT_NEAR(-trace.samples.front().residual, half_the_jump, published * half_the_jump);
    for (const core::Sample& sample : trace.samples) {
        ASSERT_NEAR(sample.residual, trace.samples.front().residual, books * trace.peak_work) << "at " << sample.time << " s";
    }
    expect_sound(trace);
}

TEST(NeedleAlone, IsLetGoByAHandThatDrawsBack) {
    const core::Override there_and_back{
        "device",
        "{type: recorded_hand, tip_start: [0 mm, 0 mm, 0 mm], motion: [{insert: 2 mm, speed: 2 mm/s}, {withdraw: 2 mm, speed: "
        "2 mm/s}]}"};
    const Trace trace = play(own_scene("column_in_air_pinned"), {there_and_back});
    print_events(trace);
    const core::Sample& last = trace.samples.back();
    EXPECT_EQ(last.deflection, 0.0);
    EXPECT_LT(std::abs(last.stored), books * trace.peak_work);
    EXPECT_EQ(trace.names(), (std::vector<std::string>{"buckled", "straightened"}));
    expect_sound(trace);
}

TEST(NeedleAlone, WithAFreeTipBucklesAtASixteenthOfTheClampedLoad) {
    const Trace trace =
        play(own_scene("column_in_air_end_load"), {{"needle.ends", "clamped-free"}, {"effects[0].force", "[0 N, 0 N, 0.08 N]"}});
    const double load = pi * pi / 4.0 * stiffness / (length * length);
    ASSERT_NE(trace.first("buckled"), nullptr);
    measured("buckled_at", trace.first("buckled")->hand_force, "N");
    EXPECT_NEAR(trace.first("buckled")->hand_force, load, published * load);
    expect_sound(trace, books);
}

TEST(NeedleAlone, ARigidOneFeelsTheLoadAndDoesNotMove) {
    Stage stage(own_scene("column_in_air_end_load"), {{"needle.type", "rigid"}, {"effects[0].force", "[0.1 N, 0 N, 0.67 N]"}});
    const Trace trace = play(stage);
    EXPECT_TRUE(trace.events.empty());
    EXPECT_NEAR(trace.samples.back().hand_force, 0.67, tabulated);
    EXPECT_LE(stage.cast().needle().position(length).norm(), 1e-12);
    EXPECT_LE(trace.samples.back().load_work, 0.67 * 0.67 * gives) << "what it leans on gives a nanometre for a newton";
    expect_sound(trace, books);
}

TEST(NeedleAlone, WithoutAnEffectIsMovedThroughTheAirForNothing) {
    const core::Override up{"device",
                            "{type: recorded_hand, tip_start: [0 mm, 0 mm, 0 mm], motion: [{withdraw: 20 mm, speed: 20 mm/s}]}"};
    const Trace trace = play(own_scene("column_in_air_pinned"), {{"effects", "[]"}, up});
    EXPECT_TRUE(trace.events.empty());
    EXPECT_EQ(trace.peak_hand_force(), 0.0);
    EXPECT_EQ(trace.peak_work, 0.0);
    EXPECT_NEAR(trace.samples.back().travel, -20e-3, 1e-12);
}

TEST(NeedleAlone, BringsNoLibraryOfATissueOrADevice) {
    {
        Stage stage(own_scene("column_in_air_end_load"));
        (void)play(stage);
        EXPECT_EQ(mapped_plugins(), (std::vector<std::string>{"beam_column", "end_load", "euler"}));
    }
    Stage stage(own_scene("column_in_air_pinned"));
    (void)play(stage);
    EXPECT_EQ(mapped_plugins(), (std::vector<std::string>{"beam_column", "euler", "pin", "recorded_hand"}));
}

TEST(NeedleAlone, AllocatesNothingInATick) {
    for (const char* name : {"column_in_air_end_load", "column_in_air_pinned"}) {
        Stage stage(own_scene(name));
        const std::size_t before = contract::allocations(), ticks = stage.ticks();
        for (std::size_t tick = 0; tick < ticks; ++tick) stage.simulation().tick();
        EXPECT_EQ(contract::allocations() - before, 0u) << name;
    }
}

}    // namespace
}    // namespace stylet::whole_scenes
