#include "apps/study/changes.h"

#include <algorithm>

namespace stylet::study {
namespace {

bool lies_in(const std::string& key, const std::string& map) {
    return key.starts_with(map) && (key.size() == map.size() || key[map.size()] == '.' || key[map.size()] == '[');
}

}    // namespace

std::vector<core::Override> joined(std::vector<core::Override> changes, const std::vector<core::Override>& later) {
    for (const core::Override& change : later) {
        std::erase_if(changes, [&](const core::Override& earlier) { return lies_in(earlier.key, change.key); });
        changes.push_back(change);
    }
    std::ranges::stable_sort(changes, {}, &core::Override::key);
    return changes;
}

}    // namespace stylet::study
