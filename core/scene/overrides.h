#pragma once

#include "core/scene/reader.h"
#include "core/scene/value_tree.h"

namespace stylet::core {

/// Puts each override's value into the tree, as if the scene had said so, or takes its key out, as if it had not. An index is
/// that of the list as the scene, or the last override of the whole list, has it, whatever else is taken out. Complains of keys
/// that lead nowhere and of bad YAML.
void apply_overrides(const std::vector<Override>& overrides, ValueTree& scene, Complaints& complaints);

}    // namespace stylet::core
