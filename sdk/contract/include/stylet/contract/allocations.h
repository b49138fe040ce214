#pragma once

#include <cstddef>

namespace stylet::contract {

/// How often this process has asked for memory since it began: by new, by malloc (as Eigen does) and their kin.
[[nodiscard]] std::size_t allocations();

}    // namespace stylet::contract
