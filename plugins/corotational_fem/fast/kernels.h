// The loops that are compiled once for each kind of processor (kernels_<set>.cpp), and how a set is chosen when a scene is
// loaded.
//
// A function compiled for AVX-512 crashes any older processor, and the linker keeps one of several copies of an inline function:
// so those files include no header that holds inline code (no Eigen, no standard containers or algorithms), only plain structs,
// the processor's intrinsics and *.inl files, which become part of a namespace of that set.
#pragma once

#include <cstddef>
#include <cstdint>

namespace stylet::corotational_fem {

enum class InstructionSet : std::uint8_t { sse2, avx2, avx512 };    // x86-64; with FMA and F16C; with F, BW, DQ and VL

/// Whether this processor, under this operating system, can run it.
[[nodiscard]] bool supported(InstructionSet set);

[[nodiscard]] InstructionSet best_instruction_set();

[[nodiscard]] const char* name(InstructionSet set);

/// Products with the dense blocks of a supernode, for blocks stored in one way.
///
/// A tile is 16 × 16 numbers, column by column. A symmetric matrix S of n × n tiles is stored as, for each column of tiles, the
/// diagonal one and those below it; a matrix M of m × n tiles as all of each column of tiles. Vectors are padded with zeros to
/// whole sixteens, and aligned to 64 bytes as the tiles are; the columns of three follow each other.
struct PanelProducts {
    /// Of the columns of tiles [first, last), and what mirrors them.
    void (*symmetric)(const void* s, int n, int first, int last, const float* b, float* y);    // y += S b
    void (*general)(const void* m, int rows, int columns, const float* b, float* u);           // u += M b
    void (*transposed)(const void* m, int rows, int columns, const float* u, float* b);        // b −= Mᵀ u
    void (*symmetric_of_three)(const void* s, int n, const float* b, float* y);
    void (*general_of_three)(const void* m, int rows, int columns, const float* b, float* u);
};

struct PanelKernels {
    PanelProducts whole;    // stored as float
    PanelProducts half;     // stored as IEEE half precision; null pointers where the processor can't convert it

    /// products[3 i + j] += aᵢ·bⱼ of three vectors each, of `length` numbers.
    void (*dots)(const float* a, const float* b, int length, float* products);
    /// products[i] += aᵢ·b
    void (*dots_with_one)(const float* a, const float* b, int length, float* products);
    /// b += Σ fᵢ aᵢ
    void (*add)(const float* a, const float* f, int length, float* b);
};

/// C −= V Wᵀ for a few rows and columns of C, in double precision: V `depth` columns of `rows` numbers one after the other, W
/// likewise, C column by column, `stride` apart.
struct DenseKernel {
    int rows, columns;    // divide 24
    void (*subtract_product)(const double* v, const double* w, int depth, double* c, std::ptrdiff_t stride);
};

/// Of a set that this processor supports.
[[nodiscard]] const DenseKernel& dense_kernel(InstructionSet set);
[[nodiscard]] const PanelKernels& panel_kernels(InstructionSet set);

}    // namespace stylet::corotational_fem
