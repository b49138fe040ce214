// Any bytes as a file of recorded poses: they are read as promised, or refused with a line.
#include "plugins/recorded_hand/pose_file.h"

#include "tests/fuzzing/input_file.h"

#include <cmath>

namespace stylet::recorded_hand {
namespace {

void check(const auto& keys) {
    fuzzing::demand(!keys.empty(), "a hand has a pose");
    double before = -1.0;    // [s]
    for (const auto& key : keys) {
        constexpr double rounding = 1e-15;    // of a normalised quaternion's length
        fuzzing::demand(std::isfinite(key.time) && key.time >= 0.0 && key.time > before, "times rise from 0 on");
        fuzzing::demand(key.pose.position.allFinite(), "positions are finite");
        fuzzing::demand(std::abs(key.pose.rotation.norm() - 1.0) <= rounding, "rotations are unit quaternions");
        before = key.time;
    }
}

}    // namespace
}    // namespace stylet::recorded_hand

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace stylet;
    static const fuzzing::Folder folder;
    const std::filesystem::path file = folder.path() / "poses.csv";
    fuzzing::write(file, fuzzing::bytes_of(data, size));
    try {
        recorded_hand::check(recorded_hand::read_pose_file(file));
    } catch (const Error& error) {
        fuzzing::demand(error.key() == "file", "the file is at fault");
        fuzzing::demand_sentence(error.what());
    }
    return 0;
}
