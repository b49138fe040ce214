#pragma once

#include "apps/stylet/critical_loads.h"
#include "apps/stylet/figure.h"

namespace stylet::app {

/// Critical load over the axis (or Eq. (3)'s stiffness, where it was asked for), with the force at which the tip punctures and,
/// of one scene, what cutting and friction ask for inside. A curve that agrees with one before it is dotted over it. Throws
/// Failure where there is one point only.
[[nodiscard]] Figure figure_of(const CriticalLoads& loads);

}    // namespace stylet::app
