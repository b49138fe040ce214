#include "apps/study/measurements.h"

#include "apps/study/run_log.h"
#include "apps/study/stopwatch.h"
#include "core/workers/worker_pool.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>

namespace stylet::study {
namespace {

constexpr std::atomic<bool> never{false};

class Measurements {
public:
    Measurements(const Plan& plan, const Options& options)
        : plan_(plan),
          options_(options),
          stop_(options.stop == nullptr ? never : *options.stop),
          log_(options.log, options.again),
          outcomes_(plan.jobs.size()) {
        for (std::size_t i = 0; i < plan.jobs.size(); ++i) {
            if (const Outcome* known = log_.find(plan.jobs[i].key)) {
                outcomes_[i] = *known;
            } else {
                left_.push_back(i);
            }
        }
    }

    /// What each job left; nothing where it was stopped.
    std::vector<std::optional<Outcome>> take(bool timed) {
        const std::size_t threads = timed ? 1 : std::min(left_.size(), static_cast<std::size_t>(core::processors()));
        std::vector<std::thread> others;
        for (std::size_t i = 1; i < threads; ++i) others.emplace_back([this] { work(); });
        work();
        for (std::thread& other : others) other.join();
        if (failed_) std::rethrow_exception(failed_);
        return std::move(outcomes_);
    }

private:
    void work() {
        try {
            for (std::size_t next = next_++; next < left_.size() && !stop_ && !given_up_; next = next_++) {
                const Job& job = plan_.jobs[left_[next]];
                const auto progress = [&](double share) { tell(job.name, share); };
                progress(0.0);
                const auto outcome = measure(job, options_.folders, stop_, progress);
                if (!outcome) return;
                log_.add(job.key, job.name, *outcome);
                outcomes_[left_[next]] = *outcome;
                ++done_;
            }
        } catch (...) {
            const std::lock_guard lock(mutex_);
            failed_ = std::current_exception();
            given_up_ = true;
        }
    }

    void tell(const std::string& name, double share) {
        if (!options_.progress) return;
        const auto done = static_cast<double>(done_) + share, all = static_cast<double>(left_.size());
        const std::lock_guard lock(mutex_);
        Progress progress{
            .done = static_cast<std::size_t>(done_), .all = left_.size(), .share = done / all, .seconds_left = {}, .name = name};
        if (done > 0.0) progress.seconds_left = watch_.wall() * (all - done) / done;
        options_.progress(progress);
    }

    const Plan& plan_;
    const Options& options_;
    const std::atomic<bool>& stop_;
    RunLog log_;
    std::vector<std::optional<Outcome>> outcomes_;
    std::vector<std::size_t> left_;    // still to be measured
    std::atomic<std::size_t> next_{0}, done_{0};
    std::atomic<bool> given_up_{false};
    std::exception_ptr failed_;
    std::mutex mutex_;
    Stopwatch watch_;
};

}    // namespace

std::vector<std::optional<Outcome>> measure_all(const Plan& plan, bool timed, const Options& options) {
    return Measurements(plan, options).take(timed);
}

}    // namespace stylet::study
