// The loops that are compiled once for each kind of processor (kernels_<set>.cpp), and how a set is chosen when a scene is
// loaded.
//
// A function compiled for AVX-512 crashes any older processor, and the linker keeps one of several copies of an inline function:
// so those files include no header that holds inline code (no Eigen, no standard containers or algorithms), only plain structs,
// the processor's intrinsics and *.inl files, which become part of a namespace of that set.
#pragma once

#include <cstdint>

namespace stylet::corotational_fem {

enum class InstructionSet : std::uint8_t { sse2, avx2, avx512 };    // x86-64; with FMA and F16C; with F, BW, DQ and VL

/// Whether this processor, under this operating system, can run it.
[[nodiscard]] bool supported(InstructionSet set);

[[nodiscard]] InstructionSet best_instruction_set();

[[nodiscard]] const char* name(InstructionSet set);

/// Products with the dense blocks of a supernode (panels.h tells how they lie), for blocks stored in one way.
///
/// A tile is 16 × 16 numbers, column by column. Vectors are padded with zeros to whole sixteens, and aligned to 64 bytes as the
/// tiles are.
struct PanelProducts {
    /// y += S b, of a symmetric matrix S of `tiles` × `tiles`. Stored: of each column of tiles the diagonal one and those below
    /// it.
    void (*symmetric)(const void* stored, int tiles, const float* b, float* y);

    /// u += M b for the rows of tiles [first, last) of a matrix M of `rows` × `columns` tiles, stored column of tiles by column.
    void (*general)(const void* stored, int rows, int columns, int first, int last, const float* b, float* u);

    /// b −= Mᵀ u.
    void (*transposed)(const void* stored, int rows, int columns, const float* u, float* b);
};

struct PanelKernels {
    PanelProducts whole;    // stored as float
    PanelProducts half;     // stored as IEEE half precision; null pointers where the processor can't convert it

    /// products[3 i + j] += aᵢ·bⱼ, of three vectors each, one after the other, of `length` numbers, padded.
    void (*dots)(const float* a, const float* b, int length, float* products);
};

/// Of a set that this processor supports.
[[nodiscard]] const PanelKernels& panel_kernels(InstructionSet set);

}    // namespace stylet::corotational_fem
