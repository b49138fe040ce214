#pragma once

#include "apps/study/result.h"

#include <optional>
#include <span>
#include <string>

namespace stylet::study {

/// The order p of error ≈ C number^p, by least squares of log error over log number: −2 where twice the elements leave a quarter
/// of the error, 2 where half the step does. `numbers` are the values of `key`, in any order, `errors` as many.
///
/// From the largest error (the coarse end: what is coarser still says nothing yet) towards the fine one, the errors are followed
/// until one no longer falls: by less than number^¼ of its neighbour. What is left there is not the key's (a solver's tolerance,
/// another part of the model). That floor is the largest error from there on; points below three times the floor are left out,
/// as it makes up more than a third of them. So are numbers and errors that are not finite and above 0. Settings with the same
/// number (where another key varies, too) count as one, with the mean of their logarithms.
/// None where fewer than three points remain: through two there is always a line. `least_error` is the smallest that was fitted.
[[nodiscard]] std::optional<FittedOrder> fitted_order(const std::string& series, const std::string& key,
                                                      std::span<const double> numbers, std::span<const double> errors);

}    // namespace stylet::study
