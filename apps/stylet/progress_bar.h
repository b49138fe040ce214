#pragma once

#include <chrono>
#include <string>

namespace stylet::app {

/// A bar on stderr for runs that take longer than a second, and only where stderr is a terminal. Gone when it goes.
class ProgressBar {
public:
    explicit ProgressBar(std::string label);
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;
    ~ProgressBar();

    void show(double fraction) { show(fraction, label_); }    // from 0 to 1

    /// With another label than the bar's own.
    void show(double fraction, const std::string& label);

private:
    using Clock = std::chrono::steady_clock;

    std::string label_;
    bool terminal_;
    bool drawn_ = false;
    Clock::time_point next_;
};

}    // namespace stylet::app
