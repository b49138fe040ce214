#pragma once

#include "core/scene/reader.h"

#include <vector>

namespace stylet::study {

/// Changes of a scene with further ones after them. A later one takes the place of earlier ones of its key and of every key
/// within it; all are in the order of their keys, maps before what is within them, so that equal changes look equal.
[[nodiscard]] std::vector<core::Override> joined(std::vector<core::Override> changes, const std::vector<core::Override>& later);

}    // namespace stylet::study
