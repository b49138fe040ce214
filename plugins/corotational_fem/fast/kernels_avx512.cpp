// Compiled with -mavx512f -mavx512bw -mavx512dq -mavx512vl -mfma -mf16c; see kernels.h before including anything here.
#include "fast/element_pass.h"
#include "fast/kernels.h"
#include "fast/lanes.h"

#include <immintrin.h>

namespace stylet::corotational_fem::avx512 {

inline constexpr int native_lanes = 16;    // floats in a register

#include "fast/dense.inl"
#include "fast/element_pass.inl"
#include "fast/panels.inl"

}    // namespace stylet::corotational_fem::avx512
