#include "apps/study/timing.h"

#include "apps/study/errors.h"

#include <algorithm>
#include <iterator>

namespace stylet::study {
namespace {

double median_of(const std::vector<Timing>& timings, double Timing::*member) {
    std::vector<double> values;
    for (const Timing& timing : timings) values.push_back(timing.*member);
    std::ranges::sort(values);
    return quantile(values, 0.5);
}

Timing together(const std::vector<Timing>& timings) {
    Timing all{.median = median_of(timings, &Timing::median),
               .p99 = median_of(timings, &Timing::p99),
               .mean = median_of(timings, &Timing::mean)};
    for (const Timing& timing : timings) {
        all.worst = std::max(all.worst, timing.worst);
        all.waited = std::max(all.waited, timing.waited);
    }
    return all;
}

}    // namespace

Timing of_repetitions(std::vector<Timing> timings, int count) {
    std::ranges::sort(timings, {}, &Timing::waited);
    timings.resize(std::min(timings.size(), static_cast<std::size_t>(count)));
    Timing all = together(timings);
    all.contended = all.waited > most_waited;
    return all;
}

Timing of_cases(const std::vector<Timing>& timings) {
    Timing all = together(timings);
    all.waited = median_of(timings, &Timing::waited);
    all.contended = 2 * std::ranges::count_if(timings, &Timing::contended) > std::ssize(timings);
    return all;
}

}    // namespace stylet::study
