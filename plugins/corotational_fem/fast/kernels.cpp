#include "fast/kernels.h"

#include <cpuid.h>

namespace stylet::corotational_fem {

namespace sse2 {
extern const DenseKernel dense_kernel;
extern const PanelKernels panel_kernels;
}    // namespace sse2
namespace avx2 {
extern const DenseKernel dense_kernel;
extern const PanelKernels panel_kernels;
}    // namespace avx2
namespace avx512 {
extern const DenseKernel dense_kernel;
extern const PanelKernels panel_kernels;
}    // namespace avx512

namespace {

// Clang's __builtin_cpu_supports doesn't know the name. What the operating system must do for it is the same as for AVX.
bool has_f16c() {
    unsigned a = 0, b = 0, c = 0, d = 0;
    return __get_cpuid(1, &a, &b, &c, &d) != 0 && (c & bit_F16C) != 0;
}

}    // namespace

bool supported(InstructionSet set) {
    const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && has_f16c();
    switch (set) {
        case InstructionSet::sse2:
            return true;
        case InstructionSet::avx2:
            return avx2;
        case InstructionSet::avx512:
            break;
    }
    return avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
}

InstructionSet best_instruction_set() {
    if (supported(InstructionSet::avx512)) return InstructionSet::avx512;
    return supported(InstructionSet::avx2) ? InstructionSet::avx2 : InstructionSet::sse2;
}

const char* name(InstructionSet set) {
    switch (set) {
        case InstructionSet::sse2:
            return "SSE2";
        case InstructionSet::avx2:
            return "AVX2";
        case InstructionSet::avx512:
            break;
    }
    return "AVX-512";
}

const DenseKernel& dense_kernel(InstructionSet set) {
    switch (set) {
        case InstructionSet::sse2:
            return sse2::dense_kernel;
        case InstructionSet::avx2:
            return avx2::dense_kernel;
        case InstructionSet::avx512:
            break;
    }
    return avx512::dense_kernel;
}

const PanelKernels& panel_kernels(InstructionSet set) {
    switch (set) {
        case InstructionSet::sse2:
            return sse2::panel_kernels;
        case InstructionSet::avx2:
            return avx2::panel_kernels;
        case InstructionSet::avx512:
            break;
    }
    return avx512::panel_kernels;
}

}    // namespace stylet::corotational_fem
