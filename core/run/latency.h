#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace stylet::core {

/// How often a time fell into each of a few bins, coarser the longer it is. Neither allocates nor forgets.
class Latency {
public:
    static constexpr std::array<double, 16> upper_bounds{
        1.0,   2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0,
        500.0, 1e3, 2e3, 5e3,  10e3, 20e3, 50e3,  100e3};    // [µs]; the last bin has none
    static constexpr std::size_t bins = upper_bounds.size() + 1;

    /// `time` in µs.
    void add(double time) {
        ++counts_[static_cast<std::size_t>(std::ranges::upper_bound(upper_bounds, time) - upper_bounds.begin())];
        worst_ = std::max(worst_, time);
    }

    [[nodiscard]] const std::array<std::size_t, bins>& counts() const { return counts_; }
    [[nodiscard]] double worst() const { return worst_; }    // [µs]

private:
    std::array<std::size_t, bins> counts_{};
    double worst_ = 0.0;
};

}    // namespace stylet::core
