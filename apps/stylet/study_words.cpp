#include "apps/stylet/study_words.h"

#include <fmt/format.h>

namespace stylet::app {

std::string machine_text(const study::Machine& machine) {
    return fmt::format("{}, {} processor{}, {}; {}", machine.processor, machine.processors, machine.processors == 1 ? "" : "s",
                       machine.system, machine.build);
}

std::string order_text(const study::FittedOrder& order) {
    return fmt::format("{}: error ~ {}^{:.2f} ({} points above {})", order.series, order.key, order.order, order.points,
                       error_text(order.least_error));
}

}    // namespace stylet::app
