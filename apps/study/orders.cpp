#include "apps/study/orders.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace stylet::study {
namespace {

struct LogPoint {
    double number, error;    // logarithms
};

/// By growing number, each once.
std::vector<LogPoint> log_points(std::span<const double> numbers, std::span<const double> errors) {
    struct Sum {
        double logs = 0.0;
        int count = 0;
    };
    std::map<double, Sum> sums;
    for (std::size_t i = 0; i < std::min(numbers.size(), errors.size()); ++i) {
        if (!std::isfinite(numbers[i]) || !std::isfinite(errors[i]) || numbers[i] <= 0.0 || errors[i] <= 0.0) continue;
        Sum& sum = sums[numbers[i]];
        sum.logs += std::log(errors[i]);
        ++sum.count;
    }
    std::vector<LogPoint> points;
    for (const auto& [number, sum] : sums) points.push_back({std::log(number), sum.logs / sum.count});
    return points;
}

double slope(std::span<const LogPoint> points) {
    double number = 0.0, error = 0.0, squares = 0.0, products = 0.0;
    for (const LogPoint& point : points) {
        number += point.number / static_cast<double>(points.size());
        error += point.error / static_cast<double>(points.size());
    }
    for (const LogPoint& point : points) {
        squares += std::pow(point.number - number, 2);
        products += (point.number - number) * (point.error - error);
    }
    return products / squares;
}

/// Those from the largest error on towards the fine end that say what the order is.
std::vector<LogPoint> above_floor(std::vector<LogPoint> points) {
    constexpr double least_order = 0.25;    // less is no fall
    const double share_of_floor = std::log(3.0);
    if (slope(points) > 0.0) std::ranges::reverse(points);    // a step: the fine end is the small one
    points.erase(points.begin(), std::ranges::max_element(points, {}, &LogPoint::error));
    std::size_t falling = 1;
    while (falling < points.size() && points[falling - 1].error - points[falling].error >=
                                          least_order * std::abs(points[falling].number - points[falling - 1].number)) {
        ++falling;
    }
    if (falling == points.size()) return points;
    const double floor = std::max_element(points.begin() + static_cast<std::ptrdiff_t>(falling), points.end(),
                                          [](const LogPoint& a, const LogPoint& b) { return a.error < b.error; })
                             ->error;
    points.resize(falling);
    std::erase_if(points, [&](const LogPoint& point) { return point.error < floor + share_of_floor; });
    return points;
}

}    // namespace

std::optional<FittedOrder> fitted_order(const std::string& series, const std::string& key, std::span<const double> numbers,
                                        std::span<const double> errors) {
    constexpr std::size_t fewest = 3;
    std::vector<LogPoint> points = log_points(numbers, errors);
    if (points.size() < fewest) return std::nullopt;
    points = above_floor(std::move(points));
    if (points.size() < fewest) return std::nullopt;
    return FittedOrder{.series = series,
                       .key = key,
                       .order = slope(points),
                       .least_error = std::exp(std::ranges::min(points, {}, &LogPoint::error).error),
                       .points = static_cast<int>(points.size())};
}

}    // namespace stylet::study
