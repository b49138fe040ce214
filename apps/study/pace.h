// How much longer, while settings of very different cost are measured one after the other.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

namespace stylet::study {

/// Four kinds of runs, in this order. What is not measured yet is taken to last as long as those of its kind did; before there is
/// one, as the first run of all did, a reference four times as long as the longest.
class Pace {
public:
    enum Kind : std::size_t { models, references, steps, omissions };

    void expect(std::size_t of_models, std::size_t of_steps, std::size_t of_omissions) {
        all_ = {of_models, 1, of_steps, of_omissions};
    }

    void done(Kind kind, double seconds) {
        if (count_done() == 0) first_ = seconds;
        longest_ = std::max(longest_, seconds);
        spent_[kind] += seconds;
        ++done_[kind];
        all_[kind] = std::max(all_[kind], done_[kind]);
    }

    [[nodiscard]] bool known() const { return count_done() > 0; }
    [[nodiscard]] std::size_t count() const { return std::reduce(all_.begin(), all_.end()); }
    [[nodiscard]] std::size_t count_done() const { return std::reduce(done_.begin(), done_.end()); }

    /// [s] to come, while a run of this kind has done this share of itself in so many seconds.
    [[nodiscard]] double left(Kind kind, double share, double seconds) const {
        double left = share > 0.0 ? seconds * (1.0 - share) / share : each(kind);
        for (const Kind other : {models, references, steps, omissions}) {
            const std::size_t runs = all_[other] - std::min(all_[other], done_[other] + (other == kind ? 1 : 0));
            left += static_cast<double>(runs) * each(other);
        }
        return left;
    }

private:
    [[nodiscard]] double each(Kind kind) const {
        if (done_[kind] > 0) return spent_[kind] / static_cast<double>(done_[kind]);
        constexpr double finer = 4.0;
        return kind == references ? finer * longest_ : first_;
    }

    std::array<std::size_t, 4> all_{}, done_{};
    std::array<double, 4> spent_{};         // [s]
    double first_ = 0.0, longest_ = 0.0;    // [s]
};

}    // namespace stylet::study
