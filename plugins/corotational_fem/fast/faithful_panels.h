// How small the numbers of a factor may be stored.
#pragma once

#include "fast/panels.h"

#include <memory>

namespace stylet::corotational_fem {

/// What is left of an error after one correction x += P (b − A x) with these panels as P, at worst: the greatest eigenvalue of
/// I − P A, which a few rounds of the power method find to some tens of percent. NaN where the storage can't hold the factor.
[[nodiscard]] double error_left(Panels& panels, const BlockMatrix& matrix, Workers& workers);

/// Panels in half precision where the processor converts it and its rounding leaves little of any error, else in single.
///
/// Rounding is relative to a supernode's stiffest motions, and what it does to the softest shows in how far materials differ:
/// 0.01 is left in a tissue of one, 0.1 where ν = 0.499, some hundreds in a soft layer under one a million times as stiff. An
/// iteration that takes P for A⁻¹ has to live with what the tissue's own change of stiffness leaves, 0.05 and up.
[[nodiscard]] std::unique_ptr<Panels> faithful_panels(const Factor& factor, const BlockMatrix& matrix, InstructionSet set,
                                                      Workers& workers);

}    // namespace stylet::corotational_fem
