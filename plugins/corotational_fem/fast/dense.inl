// A product in double precision (kernels.h). Part of a namespace of one instruction set, which says native_lanes.

namespace {

using DoublesInRegister = double __attribute__((vector_size(native_lanes * sizeof(float)), aligned(8)));

constexpr int doubles = native_lanes / 2;                       // in a register
constexpr int dense_rows = 3 * doubles;                         // with 4 or 8 columns: as many sums as leave registers free
constexpr int dense_columns = native_lanes == 16 ? 8 : 4;

void subtract_product(const double* v, const double* w, int depth, double* c, std::ptrdiff_t stride) {
    DoublesInRegister sums[dense_columns][3] = {};
    for (int k = 0; k < depth; ++k, v += dense_rows, w += dense_columns) {
        const DoublesInRegister* const column = reinterpret_cast<const DoublesInRegister*>(v);
        const DoublesInRegister v0 = column[0], v1 = column[1], v2 = column[2];
#pragma GCC unroll 8
        for (int j = 0; j < dense_columns; ++j) {
            sums[j][0] += v0 * w[j];
            sums[j][1] += v1 * w[j];
            sums[j][2] += v2 * w[j];
        }
    }
#pragma GCC unroll 8
    for (int j = 0; j < dense_columns; ++j) {
        DoublesInRegister* const column = reinterpret_cast<DoublesInRegister*>(c + j * stride);
        for (int i = 0; i < 3; ++i) column[i] -= sums[j][i];
    }
}

}    // namespace

extern const DenseKernel dense_kernel{dense_rows, dense_columns, subtract_product};
