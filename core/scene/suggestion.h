#pragma once

#include <string>
#include <vector>

namespace stylet::core {

/// "; did you mean 'radius'?" where one of `candidates` is near enough to `word` to be meant, else nothing. Nearness counts
/// letters added, left out, replaced or swapped with their neighbour (Damerau 1964); a third of the word may be wrong.
/// Of words as near as each other the one whose number is nearest: 34G for 35G.
[[nodiscard]] std::string suggestion(const std::string& word, const std::vector<std::string>& candidates);

}    // namespace stylet::core
