// Products with 16 × 16 tiles (kernels.h). Part of a namespace of one instruction set, which says native_lanes.

namespace {

#define STYLET_INLINE inline __attribute__((always_inline))

using Native = float __attribute__((vector_size(native_lanes * sizeof(float))));

constexpr int tile = lanes * lanes;            // numbers in a tile
constexpr int parts = lanes / native_lanes;    // registers in a column of a tile

STYLET_INLINE Native load(const float* from) { return *reinterpret_cast<const Native*>(from); }

#if defined(__AVX512F__)
STYLET_INLINE Native load(const std::uint16_t* from) {
    // Without the mask g++ 12 warns of its own header.
    return reinterpret_cast<Native>(_mm512_maskz_cvtph_ps(0xFFFF, _mm256_load_si256(reinterpret_cast<const __m256i*>(from))));
}
#elif defined(__F16C__)
STYLET_INLINE Native load(const std::uint16_t* from) {
    return reinterpret_cast<Native>(_mm256_cvtph_ps(_mm_load_si128(reinterpret_cast<const __m128i*>(from))));
}
#endif

STYLET_INLINE void store(float* to, Native value) { *reinterpret_cast<Native*>(to) = value; }

template <int... lane>
struct Sequence {};
template <int count, int... lane>
struct Count : Count<count - 1, count - 1, lane...> {};
template <int... lane>
struct Count<0, lane...> {
    using Lanes = Sequence<lane...>;
};

// Of two vectors, in each of which `run` lanes at a time are of one sum, one in which half as many are, those of `a` first.
template <int run, int... lane>
STYLET_INLINE Native join(Native a, Native b, Sequence<lane...>) {
    return __builtin_shufflevector(a, b, (lane % run < run / 2 ? lane : native_lanes + lane - run / 2)...) +
           __builtin_shufflevector(a, b, (lane % run < run / 2 ? lane + run / 2 : native_lanes + lane)...);
}

// Lane i of the result is what all lanes of sums[i] add up to.
template <int stride = 1>
STYLET_INLINE Native join_all(const Native* sums) {
    if constexpr (stride == native_lanes) {
        return sums[0];
    } else {
        return join<2 * stride>(join_all<2 * stride>(sums), join_all<2 * stride>(sums + stride), typename Count<native_lanes>::Lanes{});
    }
}

STYLET_INLINE float sum(Native v) {
    float total = 0.0F;
#pragma GCC unroll 16
    for (int lane = 0; lane < native_lanes; ++lane) total += v[lane];
    return total;
}

// u += T b
template <class Stored>
STYLET_INLINE void add_tile(const Stored* t, const float* b, float* u) {
    Native even[parts], odd[parts];
#pragma GCC unroll 4
    for (int p = 0; p < parts; ++p) {
        even[p] = load(u + p * native_lanes);
        odd[p] = Native{};
    }
#pragma GCC unroll 16
    for (int j = 0; j < lanes; j += 2) {
#pragma GCC unroll 4
        for (int p = 0; p < parts; ++p) {
            even[p] += load(t + j * lanes + p * native_lanes) * b[j];
            odd[p] += load(t + (j + 1) * lanes + p * native_lanes) * b[j + 1];
        }
    }
#pragma GCC unroll 4
    for (int p = 0; p < parts; ++p) store(u + p * native_lanes, even[p] + odd[p]);
}

// Of a column of tiles below each other: Tᵀ u, as many of its numbers at a time as there are lanes in a register, beginning with `first`.
template <class Stored>
STYLET_INLINE Native sideways(const Stored* t, int rows, int first, const float* u) {
    Native sums[native_lanes] = {};
    t += first * lanes;
    for (int r = 0; r < rows; ++r, t += tile) {
#pragma GCC unroll 4
        for (int p = 0; p < parts; ++p) {
            const Native v = load(u + r * lanes + p * native_lanes);
#pragma GCC unroll 16
            for (int i = 0; i < native_lanes; ++i) sums[i] += load(t + i * lanes + p * native_lanes) * v;
        }
    }
    return join_all(sums);
}

template <class Stored>
void general(const void* stored, int rows, int columns, const float* b, float* u) {
    const Stored* t = static_cast<const Stored*>(stored);
    for (int c = 0; c < columns; ++c) {
        for (int r = 0; r < rows; ++r, t += tile) add_tile(t, b + c * lanes, u + r * lanes);
    }
}

template <class Stored>
void transposed(const void* stored, int rows, int columns, const float* u, float* b) {
    const Stored* t = static_cast<const Stored*>(stored);
    for (int c = 0; c < columns; ++c, t += rows * tile) {
        for (int i = c * lanes; i < (c + 1) * lanes; i += native_lanes) store(b + i, load(b + i) - sideways(t, rows, i - c * lanes, u));
    }
}

template <class Stored>
void symmetric(const void* stored, int tiles, int first, int last, const float* b, float* y) {
    const Stored* t = static_cast<const Stored*>(stored) + first * (2 * tiles - first + 1) / 2 * tile;
    for (int c = first; c < last; ++c) {
        const Stored* below = t + tile;
        for (int r = c; r < tiles; ++r, t += tile) add_tile(t, b + c * lanes, y + r * lanes);
        for (int i = c * lanes; i < (c + 1) * lanes; i += native_lanes) {
            store(y + i, load(y + i) + sideways(below, tiles - c - 1, i - c * lanes, b + (c + 1) * lanes));
        }
    }
}

// uₖ += T bₖ for three columns, `from` and `to` apart.
template <class Stored>
STYLET_INLINE void add_tile_to_three(const Stored* t, const float* b, int from, float* u, int to) {
#pragma GCC unroll 4
    for (int p = 0; p < lanes; p += native_lanes) {
        Native sums[3];
        for (int k = 0; k < 3; ++k) sums[k] = load(u + k * to + p);
#pragma GCC unroll 16
        for (int j = 0; j < lanes; ++j) {
            const Native v = load(t + j * lanes + p);
            for (int k = 0; k < 3; ++k) sums[k] += v * b[k * from + j];
        }
        for (int k = 0; k < 3; ++k) store(u + k * to + p, sums[k]);
    }
}

// yₖ += Tᵀ bₖ, likewise, of the tiles below each other; four columns of a tile at a time.
template <class Stored>
STYLET_INLINE void add_sideways_to_three(const Stored* t, int rows, const float* b, float* y, int apart) {
    for (int j = 0; j < lanes; j += 4, t += 4 * lanes) {
        Native sums[3][4] = {};
        for (int r = 0; r < rows; ++r) {
            for (int p = 0; p < lanes; p += native_lanes) {
#pragma GCC unroll 4
                for (int i = 0; i < 4; ++i) {
                    const Native v = load(t + r * tile + i * lanes + p);
                    for (int k = 0; k < 3; ++k) sums[k][i] += v * load(b + k * apart + r * lanes + p);
                }
            }
        }
        for (int k = 0; k < 3; ++k) {
            for (int i = 0; i < 4; ++i) y[k * apart + j + i] += sum(sums[k][i]);
        }
    }
}

template <class Stored>
void general_of_three(const void* stored, int rows, int columns, const float* b, float* u) {
    const Stored* t = static_cast<const Stored*>(stored);
    for (int c = 0; c < columns; ++c) {
        for (int r = 0; r < rows; ++r, t += tile) add_tile_to_three(t, b + c * lanes, columns * lanes, u + r * lanes, rows * lanes);
    }
}

template <class Stored>
void symmetric_of_three(const void* stored, int tiles, const float* b, float* y) {
    const Stored* t = static_cast<const Stored*>(stored);
    const int apart = tiles * lanes;
    for (int c = 0; c < tiles; ++c) {
        const Stored* below = t + tile;
        for (int r = c; r < tiles; ++r, t += tile) add_tile_to_three(t, b + c * lanes, apart, y + r * lanes, apart);
        add_sideways_to_three(below, tiles - c - 1, b + (c + 1) * lanes, y + c * lanes, apart);
    }
}

void dots(const float* a, const float* b, int length, float* products) {
    Native sums[9] = {};
    for (int at = 0; at < length; at += native_lanes) {
#pragma GCC unroll 3
        for (int i = 0; i < 3; ++i) {
            const Native v = load(a + i * length + at);
#pragma GCC unroll 3
            for (int j = 0; j < 3; ++j) sums[3 * i + j] += v * load(b + j * length + at);
        }
    }
    for (int i = 0; i < 9; ++i) products[i] += sum(sums[i]);
}

void dots_with_one(const float* a, const float* b, int length, float* products) {
    Native sums[3] = {};
    for (int at = 0; at < length; at += native_lanes) {
        const Native v = load(b + at);
        for (int i = 0; i < 3; ++i) sums[i] += v * load(a + i * length + at);
    }
    for (int i = 0; i < 3; ++i) products[i] += sum(sums[i]);
}

void add(const float* a, const float* f, int length, float* b) {
    for (int at = 0; at < length; at += native_lanes) {
        Native v = load(b + at);
        for (int i = 0; i < 3; ++i) v += f[i] * load(a + i * length + at);
        store(b + at, v);
    }
}

template <class Stored>
constexpr PanelProducts products{symmetric<Stored>, general<Stored>, transposed<Stored>, symmetric_of_three<Stored>,
                                 general_of_three<Stored>};

#undef STYLET_INLINE

}    // namespace

#if defined(__F16C__)
extern const PanelKernels panel_kernels{products<float>, products<std::uint16_t>, dots, dots_with_one, add};
#else
extern const PanelKernels panel_kernels{products<float>, {}, dots, dots_with_one, add};
#endif
