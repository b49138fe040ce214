#include "tests/simulated_hand/ripple.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <vector>

namespace stylet::simulated_hand {

namespace {

constexpr double slowest = 20.0, fastest = 500.0;    // [Hz]

double mean(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}    // namespace

double ripple(std::span<const double> signal, double dt) {
    const std::size_t count = signal.size(), half = count / 2;
    const double slope = (mean(signal.last(half)) - mean(signal.first(half))) / static_cast<double>(count - half);
    const double middle = 0.5 * static_cast<double>(count - 1), level = mean(signal);
    std::vector<double> tapered(count);
    double weight = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const double taper =
            0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * (static_cast<double>(i) + 0.5) / static_cast<double>(count));
        tapered[i] = taper * (signal[i] - level - slope * (static_cast<double>(i) - middle));
        weight += taper * taper;
    }
    double power = 0.0;
    const double spacing = 1.0 / (static_cast<double>(count) * dt);    // [Hz] between two lines
    for (auto line = static_cast<std::size_t>(std::ceil(slowest / spacing));
         line <= half && static_cast<double>(line) * spacing <= fastest; ++line) {
        const std::complex<double> turn =
            std::polar(1.0, -2.0 * std::numbers::pi * static_cast<double>(line) / static_cast<double>(count));
        std::complex<double> sum = 0.0, phase = 1.0;
        for (const double value : tapered) {
            sum += value * phase;
            phase *= turn;
        }
        power += (2 * line == count ? 1.0 : 2.0) * std::norm(sum);
    }
    return std::sqrt(power / (weight * static_cast<double>(count)));
}

double sustained_ripple(std::span<const double> signal, double dt) {
    const auto length = static_cast<std::size_t>(std::lround(window / dt));
    double before = 0.0, most = 0.0;
    for (std::size_t begin = 0; begin + length <= signal.size(); begin += length) {
        const double now = ripple(signal.subspan(begin, length), dt);
        most = std::max(most, std::min(before, now));
        before = now;
    }
    return most;
}

}    // namespace stylet::simulated_hand
