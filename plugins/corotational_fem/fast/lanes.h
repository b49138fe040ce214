// Sixteen numbers at a time. Written once with the compiler's own vectors and compiled once for each kind of processor
// (kernels.h): on AVX-512 one register, on AVX2 two, on any other x86-64 four.
#pragma once

namespace stylet::corotational_fem {

inline constexpr int lanes = 16;

using Lanes = float __attribute__((vector_size(lanes * sizeof(float))));

/// A nodal vector in single precision: x, y, z and nothing.
struct alignas(16) Float4 {
    float x, y, z, w;
};

}    // namespace stylet::corotational_fem
