#pragma once

#include "apps/study/plan.h"

#include <map>

namespace stylet::study {

/// The reference of a study where it is no run: a closed form, or a file.
class KnownAnswers {
public:
    /// Throws Error where a file is not what it should be, or lacks a case.
    KnownAnswers(const Study& study, const Plan& plan);

    /// What the job should give in case `c`, for which it gave `mine`.
    [[nodiscard]] Outcome of(const Job& job, std::size_t c, const Outcome& mine) const;

private:
    [[nodiscard]] std::string name_of(const Job& job, std::size_t c) const;
    void check_cases(const Plan& plan) const;

    const Study& study_;
    std::map<std::string, double> table_;
    std::optional<Outcome> curve_;
};

}    // namespace stylet::study
