#include "apps/study/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace stylet::study {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double least_covered = 0.99;    // of the reference's x: the last tick of a run may be missing, not its end
constexpr double holds_still = 1e-9;      // of the range of x: less of a move back is rounding

/// No error, and why.
ErrorOfOutcome none(const std::string& why) {
    return {infinity, why};
}

bool all_finite(const std::vector<double>& numbers) {
    return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
}

/// What keeps an outcome from being compared; empty where nothing does.
std::string fault_of(const Outcome& outcome) {
    if (!outcome.missing.empty()) return outcome.missing;
    const bool curve = !outcome.x.empty();
    if (outcome.y.size() != (curve ? outcome.x.size() : 1)) {
        return fmt::format("found {} values, wanted {}", outcome.y.size(), curve ? fmt::format("{}", outcome.x.size()) : "one");
    }
    if (!all_finite(outcome.x) || !all_finite(outcome.y)) return "not finite";
    if (!curve) return {};
    double furthest = outcome.x.front();
    const double rounding = holds_still * (std::ranges::max(outcome.x) - std::ranges::min(outcome.x));
    for (const double x : outcome.x) {
        if (x < furthest - rounding) return fmt::format("moves back from {:.6g} to {:.6g}", furthest, x);
        furthest = std::max(furthest, x);
    }
    return furthest > outcome.x.front() ? "" : "never moves";
}

/// y at x: linear between the samples, the last of those that share this x. x lies within the curve.
double value_at(const Outcome& curve, double x) {
    const auto after = std::upper_bound(curve.x.begin(), curve.x.end(), x);
    if (after == curve.x.end()) return curve.y.back();
    const std::size_t next = static_cast<std::size_t>(after - curve.x.begin());
    if (next == 0) return curve.y.front();
    const double share = (x - curve.x[next - 1]) / (curve.x[next] - curve.x[next - 1]);
    return std::lerp(curve.y[next - 1], curve.y[next], share);
}

/// The same curve whose x never moves back, not even by rounding.
Outcome never_back(Outcome curve) {
    double furthest = -infinity;
    for (double& x : curve.x) x = furthest = std::max(furthest, x);
    return curve;
}

/// The samples' x strictly between both ends, each once, and the ends.
std::vector<double> grid_of(const Outcome& curve, double first, double last) {
    std::vector<double> grid{first};
    for (const double x : curve.x) {
        if (x > grid.back() && x < last) grid.push_back(x);
    }
    grid.push_back(last);
    return grid;
}

ErrorOfOutcome error_of_curve(const Outcome& mine, const Outcome& reference) {
    const double first = std::max(mine.x.front(), reference.x.front()), last = std::min(mine.x.back(), reference.x.back());
    const double covered = (last - first) / (reference.x.back() - reference.x.front());
    if (covered < least_covered) {
        return none(fmt::format("covers {:.3g} % of the reference: found {:.6g} to {:.6g}, wanted {:.6g} to {:.6g}",
                                100.0 * std::max(0.0, covered), mine.x.front(), mine.x.back(), reference.x.front(),
                                reference.x.back()));
    }
    std::vector<double> grid = grid_of(mine, first, last);
    if (std::vector<double> other = grid_of(reference, first, last); other.size() < grid.size()) grid = std::move(other);
    double integral = 0.0, largest = 0.0, before = 0.0;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        const double known = value_at(reference, grid[i]);
        const double square = std::pow(value_at(mine, grid[i]) - known, 2);
        if (i > 0) integral += 0.5 * (before + square) * (grid[i] - grid[i - 1]);
        before = square;
        largest = std::max(largest, std::abs(known));
    }
    if (largest == 0.0) return none("the reference is 0 everywhere");
    return {std::sqrt(integral / (last - first)) / largest};
}

double rms(const std::vector<double>& errors) {
    const double squares = std::transform_reduce(errors.begin(), errors.end(), 0.0, std::plus{}, [](double e) { return e * e; });
    return std::sqrt(squares / static_cast<double>(errors.size()));
}

double judged(const ErrorOfCases& errors, double rms_of_all, Judge judge) {
    switch (judge) {
        case Judge::rms:
            return rms_of_all;
        case Judge::median:
            return errors.median;
        case Judge::p95:
            return errors.p95;
        case Judge::worst:
            return errors.worst;
    }
    throw std::logic_error("a judge that is not known");
}

}    // namespace

ErrorOfOutcome error_of(const Outcome& mine, const Outcome& reference) {
    if (const std::string fault = fault_of(mine); !fault.empty()) return none(fault);
    if (const std::string fault = fault_of(reference); !fault.empty()) return none("the reference: " + fault);
    if (mine.x.empty() != reference.x.empty()) {
        const auto kind = [](const Outcome& outcome) { return outcome.x.empty() ? "one value" : "a curve"; };
        return none(fmt::format("found {}, the reference is {}", kind(mine), kind(reference)));
    }
    if (!mine.x.empty()) return error_of_curve(never_back(mine), never_back(reference));
    const double value = mine.y.front(), known = reference.y.front();
    if (known == 0.0) return none("the reference is 0");
    return {std::abs(value - known) / std::abs(known)};
}

double quantile(const std::vector<double>& ordered, double share) {
    if (ordered.empty()) return infinity;
    const double place = share * static_cast<double>(ordered.size() - 1);
    const auto below = static_cast<std::size_t>(std::floor(place));
    const double past = place - static_cast<double>(below);
    if (past == 0.0 || !std::isfinite(ordered[below])) return ordered[below];
    const double above = ordered[below + 1];
    return std::isfinite(above) ? std::lerp(ordered[below], above, past) : infinity;
}

ErrorOfCases errors_of_cases(std::vector<double> errors, Judge judge) {
    for (double& error : errors) {
        if (std::isnan(error)) error = infinity;
    }
    std::ranges::sort(errors);
    ErrorOfCases result{.judged = infinity,
                        .median = quantile(errors, 0.5),
                        .p95 = quantile(errors, 0.95),
                        .worst = errors.empty() ? infinity : errors.back()};
    result.judged = judged(result, errors.empty() ? infinity : rms(errors), judge);
    return result;
}

}    // namespace stylet::study
