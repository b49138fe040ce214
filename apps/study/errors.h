// How far an outcome is from its reference, and many such errors as one.
#pragma once

#include "apps/study/outcome.h"
#include "apps/study/result.h"

#include <string>
#include <vector>

namespace stylet::study {

/// One outcome's error against its reference.
struct ErrorOfOutcome {
    double error;         // relative; infinite where `why` says something
    std::string why{};    // there is none: "never punctured"; empty where the error is finite
};

/// Of one value |y − r|/|r|. Of a curve the RMS of y − r over x as a share of the largest |r|:
///
///     √( ∫ (y − r)² dx / (x₂ − x₁) ) / max |r|
///
/// from x₁ to x₂, where both are known, by the trapezoid rule on the samples of whichever curve has fewer there (and at x₁ and
/// x₂), the other one interpolated linearly between its own: the straight lines between the points of a curve read off a picture
/// are not its points. Where x holds still the last y counts.
/// There is no error (it is infinite) where either is missing or not finite, where x moves back, where mine covers less than
/// 99 % of the reference's x (a run that ended early), or where the reference is 0 and nothing can be its share.
[[nodiscard]] ErrorOfOutcome error_of(const Outcome& mine, const Outcome& reference);

/// Quantiles by linear interpolation between the ordered errors (Hyndman and Fan 1996, type 7). Infinite where an infinite
/// error would reach the quantile; the RMS where there is one at all; all of them where there is no case.
[[nodiscard]] ErrorOfCases errors_of_cases(std::vector<double> errors, Judge judge);

/// Linear interpolation between the ordered values, at `share` in [0, 1] of the way from the first to the last.
[[nodiscard]] double quantile(const std::vector<double>& ordered, double share);

}    // namespace stylet::study
