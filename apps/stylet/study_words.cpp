#include "apps/stylet/study_words.h"

#include <fmt/format.h>

namespace stylet::app {

std::string machine_text(const study::Machine& machine) {
    return fmt::format("{}, {} processor{}, {}; {}", machine.processor, machine.processors, machine.processors == 1 ? "" : "s",
                       machine.system, machine.build);
}

std::string timed_text(const study::Result& result) {
    if (result.timed == study::Timed::nothing) return "";
    return fmt::format("{}, {} repetition{}, {} thread{}", each(result.timed), result.repetitions,
                       result.repetitions == 1 ? "" : "s", result.threads, result.threads == 1 ? "" : "s");
}

std::string remarks_text(const study::SettingResult& setting) {
    return fmt::format("{}", fmt::join(setting.remarks, "; "));
}

std::string order_text(const study::FittedOrder& order) {
    return fmt::format("{}: error ~ {}^{:.2f} ({} points above {})", order.series, order.key, order.order, order.points,
                       error_text(order.least_error));
}

}    // namespace stylet::app
