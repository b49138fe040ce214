#include "apps/stylet/interrupt.h"

#include <csignal>

namespace stylet::app {
namespace {

std::atomic<bool> asked_for{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch it");

void ask(int signal) {
    asked_for = true;
    std::signal(signal, SIG_DFL);
}

}    // namespace

Interrupt::Interrupt() {
    std::signal(SIGINT, ask);
    std::signal(SIGTERM, ask);
}

Interrupt::~Interrupt() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

const std::atomic<bool>& Interrupt::asked() {
    return asked_for;
}

}    // namespace stylet::app
