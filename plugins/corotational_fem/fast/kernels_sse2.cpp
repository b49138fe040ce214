// Compiled with nothing but x86-64 itself; see kernels.h before including anything here.
#include "fast/element_pass.h"
#include "fast/kernels.h"
#include "fast/lanes.h"

#include <immintrin.h>

namespace stylet::corotational_fem::sse2 {

inline constexpr int native_lanes = 4;    // floats in a register

#include "fast/dense.inl"
#include "fast/element_pass.inl"
#include "fast/panels.inl"

}    // namespace stylet::corotational_fem::sse2
