// What a user may give for one quantity: a value, or an interval of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace stylet::study {

enum class Spacing : std::uint8_t { linear, log };

/// "0..50mm" or "30 mm", the numbers as they are written.
struct Interval {
    double from, to;     // the same where it is one value
    std::string unit;    // of both, as it is written; empty where there is none
    std::string text;    // all of it, as it is written

    [[nodiscard]] bool one_value() const { return from == to; }

    /// The value a share (from 0 to 1) of the way along. Spaced by logarithms, both ends must be above 0.
    [[nodiscard]] double at(double share, Spacing spacing) const;

    /// `count` values, evenly spaced from end to end, both ends exact; one where there is only one.
    [[nodiscard]] std::vector<double> values(int count, Spacing spacing = Spacing::linear) const;

    /// "0.25 mm", as a scene may write it.
    [[nodiscard]] std::string quantity(double value) const;
};

/// To the digits that a sum may be trusted for: 0.3, not 0.30000000000000004.
[[nodiscard]] double rounded(double value);

/// Throws Error where the text is neither a value nor two that grow: "found …, wanted …".
[[nodiscard]] Interval read_interval(const std::string& text);

}    // namespace stylet::study
