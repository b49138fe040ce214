// How much a force trembles where a hand would feel a buzz: 20 to 500 Hz. Slower is the hand's own swing; a loop at 1 kHz knows
// no faster.
#pragma once

#include <span>

namespace stylet::simulated_hand {

inline constexpr double window = 0.2;    // [s] in which a trembling is looked for: four periods of the slowest

/// Root mean square of what a window of the signal, sampled every `dt` [s], does from 20 to 500 Hz, in the signal's own unit: by
/// Fourier sums under a Hann window, once the straight line between its halves' means is taken off.
[[nodiscard]] double ripple(std::span<const double> signal, double dt);

/// The strongest ripple that lasts: two windows in a row have at least that much. What a rupture sets ringing dies before.
[[nodiscard]] double sustained_ripple(std::span<const double> signal, double dt);

}    // namespace stylet::simulated_hand
