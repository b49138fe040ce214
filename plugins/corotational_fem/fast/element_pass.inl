// The element pass (element_pass.h). Part of a namespace of one instruction set, which says native_lanes.
//
// Everything is told by what differs from the identity, G = F − I and X = R − I, for float resolves no strain below 1e-7 of one.

namespace {

#include "fast/element_registers.inl"

struct Matrix {
    Native m[3][3];
};

#define STYLET_EACH(i) _Pragma("GCC unroll 3") for (int i = 0; i < 3; ++i)

STYLET_ALWAYS_INLINE Native squares(const Matrix& a) {
    Native sum = a.m[0][0] * a.m[0][0];
    STYLET_EACH(i) STYLET_EACH(j) if (i + j > 0) sum += a.m[i][j] * a.m[i][j];
    return sum;
}

STYLET_ALWAYS_INLINE Native product(const Matrix& a, const Matrix& b) {    // a : b
    Native sum = a.m[0][0] * b.m[0][0];
    STYLET_EACH(i) STYLET_EACH(j) if (i + j > 0) sum += a.m[i][j] * b.m[i][j];
    return sum;
}

// Whether a lane is negative.
STYLET_ALWAYS_INLINE bool any(Native lanes_below_zero) {
    using Bits = int __attribute__((vector_size(native_lanes * sizeof(int))));
    const Bits bits = Bits(lanes_below_zero);
#if defined(__AVX512F__)
    return _mm512_movepi32_mask(__m512i(bits)) != 0;
#elif defined(__AVX__)
    return _mm256_movemask_ps(__m256(bits)) != 0;
#else
    return _mm_movemask_ps(__m128(bits)) != 0;
#endif
}

// G = Σ (u_i − u_0) ⊗ ∇N_i
STYLET_ALWAYS_INLINE Matrix gradient_of(const Float4* u, const ElementBatch& batch, int lane) {
    const Registers origin = gather_corner(u, batch.nodes[0] + lane);
    Matrix g;
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
        const Registers corner = gather_corner(u, batch.nodes[i + 1] + lane);
        const Native edge[3] = {corner.x - origin.x, corner.y - origin.y, corner.z - origin.z};
        STYLET_EACH(c) {
            const Native slope = fetch(batch.gradients[i][c] + lane);
            STYLET_EACH(r) g.m[r][c] = i == 0 ? edge[r] * slope : g.m[r][c] + edge[r] * slope;
        }
    }
    return g;
}

struct Invariants {
    Matrix cofactors;
    Native trace, second, determinant;
};

STYLET_ALWAYS_INLINE Invariants invariants_of(const Matrix& x) {
    Invariants of;
    STYLET_EACH(i) STYLET_EACH(j) {
        const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
        of.cofactors.m[i][j] = x.m[a][c] * x.m[b][d] - x.m[a][d] * x.m[b][c];
    }
    of.trace = x.m[0][0] + x.m[1][1] + x.m[2][2];
    of.second = of.cofactors.m[0][0] + of.cofactors.m[1][1] + of.cofactors.m[2][2];
    of.determinant = x.m[0][0] * of.cofactors.m[0][0] + x.m[0][1] * of.cofactors.m[0][1] + x.m[0][2] * of.cofactors.m[0][2];
    return of;
}

// Half of R⁻ᵀ − I with R = I + X, whose cofactors are (1 + tr X) I − Xᵀ + cof X: ½ (cof X − Xᵀ − (II + III) I)/det R
// Then X ← X/2 + that, Higham's step (Higham 1986) without a one in it.
STYLET_ALWAYS_INLINE Matrix step(const Matrix& x, const Invariants& of) {
    const Native higher = of.second + of.determinant;
    const Native scale = 0.5F / (1.0F + (of.trace + higher));
    Matrix next;
    STYLET_EACH(i) STYLET_EACH(j) {
        Native part = of.cofactors.m[i][j] - x.m[j][i];
        if (i == j) part -= higher;
        next.m[i][j] = 0.5F * x.m[i][j] + scale * part;
    }
    return next;
}

// Within these the iteration converges in eleven steps at the worst (least stretch 0.003); in three for strains up to 0.3.
constexpr float least_volume = 0.05F;         // [1] of det F
constexpr float greatest_gradient = 10.0F;    // [1] of ‖G‖²
constexpr int most_steps = 12;
constexpr float accuracy = 1e-6F;    // [1] of R, as a part of the strain

void take_care(const Matrix& g, Native careless, Matrix& x) {
    for (int k = 0; k < native_lanes; ++k) {
        if (!(careless[k] < 0.0F)) continue;
        float gradient[9], rotation[9];
        STYLET_EACH(i) STYLET_EACH(j) gradient[3 * i + j] = g.m[i][j][k];
        careful_rotation(gradient, rotation);
        STYLET_EACH(i) STYLET_EACH(j) x.m[i][j][k] = rotation[3 * i + j];
    }
}

// X of F = I + G. Sets `inverted` where an F has a negative determinant.
STYLET_ALWAYS_INLINE Matrix rotation_of(const Matrix& g, bool& inverted) {
    const Native zero{}, minus = zero - 1.0F;
    const Invariants of = invariants_of(g);
    const Native volume = 1.0F + (of.trace + (of.second + of.determinant));
    Native careless =
        ((volume >= least_volume) & (squares(g) <= greatest_gradient)) ? zero : minus;    // not a number: careless too
    Matrix x = step(g, of);
    if (any(careless)) {
        inverted = inverted || any(volume);
        STYLET_EACH(i) STYLET_EACH(j) x.m[i][j] = careless < zero ? zero : x.m[i][j];
    }
    Native unfinished;
    for (int steps = 1;; ++steps) {
        const Matrix next = step(x, invariants_of(x));
        Native moved = zero, strain = zero;
        STYLET_EACH(i) STYLET_EACH(j) {
            const Native change = next.m[i][j] - x.m[i][j], apart = g.m[i][j] - next.m[i][j];
            moved += change * change;
            strain += apart * apart;
        }
        x = next;
        // What is left is half of moved, for the steps converge quadratically: moved/2 ≤ accuracy √strain
        unfinished = moved * moved > 4.0F * accuracy * accuracy * strain + 1e-28F ? minus : zero;
        unfinished = careless < zero ? zero : unfinished;
        if (steps + 1 == most_steps || !any(unfinished)) break;
    }
    careless = unfinished < zero ? minus : careless;
    if (any(careless)) [[unlikely]]
        take_care(g, careless, x);
    return x;
}

// f_i = V P ∇N_i, with V in P.
STYLET_ALWAYS_INLINE void store_forces(const Matrix& p, const ElementBatch& batch, int lane, CornerForces& to) {
    Registers origin{};
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
        const Native n[3] = {fetch(batch.gradients[i][0] + lane), fetch(batch.gradients[i][1] + lane),
                             fetch(batch.gradients[i][2] + lane)};
        const Registers force{p.m[0][0] * n[0] + p.m[0][1] * n[1] + p.m[0][2] * n[2],
                              p.m[1][0] * n[0] + p.m[1][1] * n[1] + p.m[1][2] * n[2],
                              p.m[2][0] * n[0] + p.m[2][1] * n[1] + p.m[2][2] * n[2]};
        store_corner(force, to.of[i + 1] + lane / 4);
        origin.x -= force.x;
        origin.y -= force.y;
        origin.z -= force.z;
    }
    store_corner(origin, to.of[0] + lane / 4);
}

STYLET_ALWAYS_INLINE void add(Native part, NativeDouble& sum) {
    sum += __builtin_convertvector(part, NativeDouble);
}

STYLET_ALWAYS_INLINE double total(const NativeDouble& sum) {
    double all = 0.0;
    for (int k = 0; k < native_lanes; ++k) all += sum[k];
    return all;
}

// sym(Rᵀ(F − F_from)), in the frame R that each tetrahedron had at the step's start.
STYLET_ALWAYS_INLINE Matrix strain_since(const ElementPass& pass, int b, int lane, const Matrix& g, const Matrix& start) {
    const Matrix before = gradient_of(pass.from, pass.batches[b], lane);
    Matrix change, turned, strain;
    STYLET_EACH(i) STYLET_EACH(j) change.m[i][j] = g.m[i][j] - before.m[i][j];
    STYLET_EACH(i) STYLET_EACH(j) {
        const Native by_turn = start.m[0][i] * change.m[0][j] + start.m[1][i] * change.m[1][j] + start.m[2][i] * change.m[2][j];
        turned.m[i][j] = change.m[i][j] + by_turn;
    }
    STYLET_EACH(i) STYLET_EACH(j) strain.m[i][j] = 0.5F * (turned.m[i][j] + turned.m[j][i]);
    return strain;
}

STYLET_ALWAYS_INLINE Native trace(const Matrix& a) {
    return a.m[0][0] + a.m[1][1] + a.m[2][2];
}

STYLET_ALWAYS_INLINE Matrix fetch(const BatchRotations& from, int lane) {
    Matrix x;
    STYLET_EACH(i) STYLET_EACH(j) x.m[i][j] = fetch(from.differences[i][j] + lane);
    return x;
}

STYLET_ALWAYS_INLINE void put(BatchRotations& to, int lane, const Matrix& x) {
    STYLET_EACH(i) STYLET_EACH(j) put(to.differences[i][j] + lane, x.m[i][j]);
}

// P += R σ with σ = τ/dt (2μ E + λ θ I). Returns what that dissipates, σ : E.
template <bool shared>
STYLET_ALWAYS_INLINE Native damp(const ElementPass& pass, int b, int lane, const Matrix& g, Matrix& p) {
    const Matrix start = fetch(pass.start_rotations[b], lane), strain = strain_since(pass, b, lane, g, start);
    const Native theta = shared ? fetch(pass.swellings[b].theta + lane) : trace(strain);
    const Native shear = pass.rate * fetch(pass.batches[b].shear + lane);
    const Native pressure = pass.rate * fetch(pass.batches[b].lame + lane) * theta;
    Matrix stress;
    STYLET_EACH(i) STYLET_EACH(j) {
        stress.m[i][j] = shear * strain.m[i][j];
        if (i == j) stress.m[i][j] += pressure;
    }
    STYLET_EACH(i) STYLET_EACH(j) {
        p.m[i][j] +=
            stress.m[i][j] + start.m[i][0] * stress.m[0][j] + start.m[i][1] * stress.m[1][j] + start.m[i][2] * stress.m[2][j];
    }
    return shear * squares(strain) + pressure * theta;
}

// θ = tr(RᵀF) − 3 = (I + X) : D, with D = F − R
STYLET_ALWAYS_INLINE Native dilatation_of(const Matrix& x, const Matrix& d) {
    return trace(d) + product(x, d);
}

enum class Damper { none, started, acting };

template <bool shared, Damper damper>
ElementSums strain(const ElementPass& pass, int first, int last) {
    NativeDouble elastic{}, dissipated{};
    bool inverted = false;
    for (int b = first; b < last; ++b) {
        const ElementBatch& batch = pass.batches[b];
        for (int lane = 0; lane < lanes; lane += native_lanes) {
            const Matrix g = gradient_of(pass.u, batch, lane);
            Matrix x, d, p;
            if constexpr (shared) {
                x = fetch(pass.rotations[b], lane);
            } else {
                x = rotation_of(g, inverted);
            }
            STYLET_EACH(i) STYLET_EACH(j) d.m[i][j] = g.m[i][j] - x.m[i][j];
            const Native theta = shared ? fetch(pass.dilatations[b].theta + lane) : dilatation_of(x, d);
            const Native shear = fetch(batch.shear + lane), pressure = fetch(batch.lame + lane) * theta;
            STYLET_EACH(i) STYLET_EACH(j) {
                p.m[i][j] = shear * d.m[i][j] + pressure * x.m[i][j];
                if (i == j) p.m[i][j] += pressure;
            }
            add(0.5F * (shear * squares(d) + pressure * theta), elastic);
            if constexpr (damper == Damper::started) put(pass.start_rotations[b], lane, x);
            if constexpr (damper == Damper::acting) add(damp<shared>(pass, b, lane, g, p), dissipated);
            store_forces(p, batch, lane, pass.forces[b]);
        }
    }
    return {total(elastic), total(dissipated), inverted};
}

template <bool damped>
bool measure(const ElementPass& pass, int first, int last) {
    bool inverted = false;
    for (int b = first; b < last; ++b) {
        for (int lane = 0; lane < lanes; lane += native_lanes) {
            const Matrix g = gradient_of(pass.u, pass.batches[b], lane);
            const Matrix x = rotation_of(g, inverted);
            Matrix d;
            STYLET_EACH(i) STYLET_EACH(j) d.m[i][j] = g.m[i][j] - x.m[i][j];
            put(pass.rotations[b], lane, x);
            put(pass.dilatations[b].theta + lane, dilatation_of(x, d));
            if constexpr (damped) {
                const Matrix start = fetch(pass.start_rotations[b], lane);
                put(pass.swellings[b].theta + lane, trace(strain_since(pass, b, lane, g, start)));
            }
        }
    }
    return inverted;
}

}    // namespace

extern const ElementKernels element_kernels{
    strain<false, Damper::none>, strain<false, Damper::started>, strain<false, Damper::acting>, measure<false>, measure<true>,
    strain<true, Damper::none>,  strain<true, Damper::started>,  strain<true, Damper::acting>};

#undef STYLET_EACH
#undef STYLET_ALWAYS_INLINE
