#include "apps/stylet/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace stylet::app {

using namespace std::chrono_literals;

ProgressBar::ProgressBar(std::string label)
    : label_(std::move(label)), terminal_(isatty(STDERR_FILENO) == 1), next_(Clock::now() + 1s) {}

ProgressBar::~ProgressBar() {
    if (drawn_) fmt::print(stderr, "\r\033[K");
}

void ProgressBar::show(double fraction, const std::string& label) {
    const Clock::time_point now = Clock::now();
    if (!terminal_ || now < next_) return;
    next_ = now + 100ms;
    drawn_ = true;
    constexpr int cells = 30;
    const double share = std::clamp(fraction, 0.0, 1.0);
    const auto full = static_cast<std::size_t>(std::lround(share * cells));
    fmt::print(stderr, "\r\033[K[{}{}] {:3.0f} %  {}", std::string(full, '#'), std::string(cells - full, '.'), share * 100.0,
               label);
    std::fflush(stderr);
}

}    // namespace stylet::app
