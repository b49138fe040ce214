// Sixteen-byte nodal vectors to and from registers of one component each. Part of a namespace of one instruction set, which says
// native_lanes, the floats in a register.

using Native = float __attribute__((vector_size(native_lanes * sizeof(float))));
using NativeDouble = double __attribute__((vector_size(native_lanes * sizeof(double))));

#define STYLET_ALWAYS_INLINE inline __attribute__((always_inline))

struct Registers {    // a vector of each lane
    Native x, y, z;
};

STYLET_ALWAYS_INLINE Native fetch(const float* from) {
    return *reinterpret_cast<const Native*>(from);
}
STYLET_ALWAYS_INLINE void put(float* to, Native value) {
    *reinterpret_cast<Native*>(to) = value;
}

// Within each sixteen bytes of a register: i, j, k, l of the first four floats of `a` and, from native_lanes on, of `b`.
#if defined(__AVX512F__)
#define STYLET_WITHIN(i, j, k, l) \
    i, j, k, l, i + 4, j + 4, k + 4, l + 4, i + 8, j + 8, k + 8, l + 8, i + 12, j + 12, k + 12, l + 12
#elif defined(__AVX__)
#define STYLET_WITHIN(i, j, k, l) i, j, k, l, i + 4, j + 4, k + 4, l + 4
#else
#define STYLET_WITHIN(i, j, k, l) i, j, k, l
#endif

STYLET_ALWAYS_INLINE Native low(Native a, Native b) {
    return __builtin_shufflevector(a, b, STYLET_WITHIN(0, native_lanes, 1, native_lanes + 1));
}
STYLET_ALWAYS_INLINE Native high(Native a, Native b) {
    return __builtin_shufflevector(a, b, STYLET_WITHIN(2, native_lanes + 2, 3, native_lanes + 3));
}
STYLET_ALWAYS_INLINE Native firsts(Native a, Native b) {
    return __builtin_shufflevector(a, b, STYLET_WITHIN(0, 1, native_lanes, native_lanes + 1));
}
STYLET_ALWAYS_INLINE Native seconds(Native a, Native b) {
    return __builtin_shufflevector(a, b, STYLET_WITHIN(2, 3, native_lanes + 2, native_lanes + 3));
}

#undef STYLET_WITHIN

// Every fourth lane's vector, side by side.
STYLET_ALWAYS_INLINE Native row_of(const Float4* u, const int* nodes) {
#if defined(__AVX512F__)
    __m512 row = _mm512_castps128_ps512(_mm_load_ps(&u[nodes[0]].x));
    row = _mm512_insertf32x4(row, _mm_load_ps(&u[nodes[4]].x), 1);
    row = _mm512_insertf32x4(row, _mm_load_ps(&u[nodes[8]].x), 2);
    return Native(_mm512_insertf32x4(row, _mm_load_ps(&u[nodes[12]].x), 3));
#elif defined(__AVX__)
    return Native(_mm256_set_m128(_mm_load_ps(&u[nodes[4]].x), _mm_load_ps(&u[nodes[0]].x)));
#else
    return Native(_mm_load_ps(&u[nodes[0]].x));
#endif
}

// Rows of four lanes' vectors in each sixteen bytes, transposed there. `nodes` and the lanes run over one register.
STYLET_ALWAYS_INLINE Registers gather_corner(const Float4* u, const int* nodes) {
    const Native row0 = row_of(u, nodes), row1 = row_of(u, nodes + 1), row2 = row_of(u, nodes + 2), row3 = row_of(u, nodes + 3);
    const Native xy01 = low(row0, row1), xy23 = low(row2, row3);
    return {firsts(xy01, xy23), seconds(xy01, xy23), firsts(high(row0, row1), high(row2, row3))};
}

// The way back, to the slots of element_pass.h: `to` is the batch's first slot plus a quarter of the register's first lane.
STYLET_ALWAYS_INLINE void store_corner(const Registers& force, Float4* to) {
    const Native none{};
    const Native xy01 = low(force.x, force.y), xy23 = high(force.x, force.y);
    const Native z01 = low(force.z, none), z23 = high(force.z, none);
    put(&to[0].x, firsts(xy01, z01));
    put(&to[4].x, seconds(xy01, z01));
    put(&to[8].x, firsts(xy23, z23));
    put(&to[12].x, seconds(xy23, z23));
}
