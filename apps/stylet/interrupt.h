#pragma once

#include <atomic>

namespace stylet::app {

/// While it lives, the first Ctrl-C (or a polite kill) asks for an end instead of ending the process, so that a recording and its
/// summary are kept; the second one ends it.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    [[nodiscard]] static const std::atomic<bool>& asked();
};

}    // namespace stylet::app
