#include <stylet/contract/contract.h>
#include <stylet/needle_model.h>

namespace stylet {
namespace {

using contract::Case;
using contract::Given;

const Given steel{{"nodes", std::int64_t{41}}, {"density", 7850.0}, {"poisson_ratio", 0.3}, {"imperfection", 2e-5}};

// [N] A needle of this length in air, its tip free, bears 0.078 N: what inertia does beyond is no matter of the contract.
constexpr double bearable = 0.02;

Given damped() {
    Given with = steel;
    with.set("damping_time", 0.05);
    return with;
}

Given bevelled() {
    Given with = damped();
    with.set("bevel_cut_angle", 0.2);
    with.set("nodes", std::int64_t{16});
    return with;
}

STYLET_CONTRACT(
    Case{.name = "Steel", .parameters = steel, .dt = 1e-2, .load = bearable},
    Case{.name = "Damped", .parameters = damped(), .load = bearable},
    Case{
        .name = "BevelledTube",
        .parameters = bevelled(),
        .needle = {.length = 0.2, .radius = 0.35e-3, .inner_radius = 0.2e-3, .youngs_modulus = 200e9, .ends = Ends::clamped_free},
        .load = bearable})

}    // namespace
}    // namespace stylet
