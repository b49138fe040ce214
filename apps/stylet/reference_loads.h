#pragma once

#include "apps/stylet/critical_loads.h"

#include <string>

namespace stylet::app {

/// Puts the known load of each scene beside it, from a CSV with the header `scene,load [N]`: a scene's file name without its
/// ending, and its load. Lines that begin with # are passed over. Throws Failure where the file lacks a scene,
/// Error where it is not such a table.
void add_references(const std::string& file, CriticalLoads& loads);

}    // namespace stylet::app
