#include "core/scene/suggestion.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace stylet::core {
namespace {

std::size_t distance(const std::string& a, const std::string& b) {
    const std::size_t columns = b.size() + 1;
    std::vector<std::size_t> table((a.size() + 1) * columns);
    const auto at = [&](std::size_t i, std::size_t j) -> std::size_t& { return table[i * columns + j]; };
    for (std::size_t i = 0; i <= a.size(); ++i) at(i, 0) = i;
    for (std::size_t j = 0; j <= b.size(); ++j) at(0, j) = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = at(i - 1, j - 1) + (a[i - 1] == b[j - 1] ? 0 : 1);
            at(i, j) = std::min({replaced, at(i - 1, j) + 1, at(i, j - 1) + 1});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
        }
    }
    return at(a.size(), b.size());
}

/// How far apart the numbers are that both begin with; 0 where one doesn't.
double between_numbers(const std::string& a, const std::string& b) {
    double one = 0.0, other = 0.0;
    if (std::from_chars(a.data(), a.data() + a.size(), one).ec != std::errc{}) return 0.0;
    if (std::from_chars(b.data(), b.data() + b.size(), other).ec != std::errc{}) return 0.0;
    return std::abs(one - other);
}

}    // namespace

std::string suggestion(const std::string& word, const std::vector<std::string>& candidates) {
    constexpr std::size_t longest = 100;    // no key is longer: keeps a mangled scene from costing time
    if (word.empty() || word.size() > longest) return "";
    std::size_t nearest = std::max<std::size_t>(1, word.size() / 3) + 1;
    const std::string* best = nullptr;
    for (const std::string& candidate : candidates) {
        if (candidate.size() > longest) continue;
        const std::size_t off = distance(word, candidate);
        const bool as_near = best != nullptr && off == nearest && between_numbers(word, candidate) < between_numbers(word, *best);
        if ((off < nearest && off < candidate.size()) || as_near) {
            nearest = off;
            best = &candidate;
        }
    }
    return best == nullptr ? "" : "; did you mean '" + *best + "'?";
}

}    // namespace stylet::core
