#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace stylet::core {

/// Quantiles of any number of durations, to 1 %, in a fixed amount of memory: a histogram whose bins grow by 1 %.
class Durations {
public:
    /// [µs]. Neither allocates nor forgets.
    void add(double duration) {
        ++counts_[bin_of(duration)];
        ++count_;
        worst_ = std::max(worst_, duration);
        sum_ += duration;
    }

    /// The least duration [µs] that this share of all of them doesn't exceed; 0 where there are none.
    [[nodiscard]] double quantile(double share) const {
        const auto wanted = static_cast<std::size_t>(std::ceil(share * static_cast<double>(count_)));
        std::size_t seen = 0;
        for (std::size_t bin = 0; bin < bins && count_ > 0; ++bin) {
            seen += counts_[bin];
            if (seen >= wanted) return std::min(shortest * std::exp((static_cast<double>(bin) + 0.5) * growth), worst_);
        }
        return worst_;
    }

    [[nodiscard]] double worst() const { return worst_; }    // [µs], exactly

    /// [µs] of all of them; 0 where there are none.
    [[nodiscard]] double mean() const { return count_ > 0 ? sum_ / static_cast<double>(count_) : 0.0; }

private:
    static constexpr double shortest = 0.01;        // [µs]
    static constexpr double growth = 0.00995033;    // ln 1.01
    static constexpr std::size_t bins = 2550;       // up to 1000 s

    static std::size_t bin_of(double duration) {
        const double bin = std::log(std::max(duration, shortest) / shortest) / growth;
        return std::min(bins - 1, static_cast<std::size_t>(bin));
    }

    std::array<std::size_t, bins> counts_{};
    std::size_t count_ = 0;
    double worst_ = 0.0, sum_ = 0.0;    // [µs]
};

}    // namespace stylet::core
