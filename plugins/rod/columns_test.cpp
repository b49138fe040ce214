// The critical loads of straight columns as the chain's own tangent has them, in air and in layers.
#include "convergence.h"
#include "equilibrium.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace stylet::rod {
namespace {

using std::numbers::pi;
constexpr int x = Equilibrium::x, y = Equilibrium::y;

// The least axial load [N] at which the straight chain's tangent K(0) − P G has a negative eigenvalue: of the pencil's
// eigenvalues the least, by halving.
double critical_load(Equilibrium& rod, double most) {
    double least = 0.0;
    for (int halvings = 0; halvings < 45; ++halvings) {
        const double middle = 0.5 * (least + most);
        (rod.negatives_at(std::vector(rod.last(), -middle)) > 0 ? most : least) = middle;
    }
    return 0.5 * (least + most);
}

// Half an edge's bending against the axis at the far end, as joint 0 does it at the base: 2EI/ℓ.
void clamp_tip(Equilibrium& rod) {
    pin_tip(rod);
    const int far = rod.last();
    rod.further = [&rod, far](const Shape&, VectorX&, BandLdlt& tangent) {    // of the straight chain
        const double length = rod.chain.edge_length(),
                     stiffness = 2.0 * rod.chain.setup().section.bending[0] / std::pow(length, 3);
        for (const int side : {x, y}) {
            const int a = rod.unknown(far - 1, side), b = rod.unknown(far, side);
            tangent.add(a, a, stiffness);
            tangent.add(b, a, -stiffness);
            tangent.add(b, b, stiffness);
        }
    };
}

TEST(RodsTangent, HasEulersLoadOfEachEnds) {
    const double tan_is_itself = 4.493409457909064;    // least root of tan λ = λ
    const auto load = [](bool clamped, void (*hold)(Equilibrium&)) {
        return [=](int elements) {
            Equilibrium rod(unit_rod(elements, clamped, 0.0));
            if (hold != nullptr) hold(rod);
            return std::vector{only(critical_load(rod, 100.0))};
        };
    };
    // Of n elements' error: (λL)²/12 of a sine's differences, in the number of sines that fit.
    expect_second_order({{"clamped-free: pi^2/4", 0.25 * pi * pi, 0.25}}, load(true, nullptr));
    expect_second_order({{"pinned-pinned: pi^2", pi * pi, 0.9}}, load(false, pin_tip));
    expect_second_order({{"clamped-pinned: 20.19", tan_is_itself * tan_is_itself, 2.1}}, load(true, pin_tip));
    expect_second_order({{"clamped-clamped: 4 pi^2", 4.0 * pi * pi, 3.4}}, load(true, clamp_tip));
}

// What a planar prototype with the same clamp had at these numbers of nodes [%].
TEST(RodsTangent, NearsTheClampedPinnedLoadFromBelow) {
    const double exact = std::pow(4.493409457909064, 2);
    for (const auto& [nodes, per_cent] : {std::pair{11, -2.0}, {21, -0.5}, {41, -0.13}, {81, -0.03}}) {
        Equilibrium rod(unit_rod(nodes - 1, true, 0.0));
        pin_tip(rod);
        const double off = 100.0 * (critical_load(rod, 100.0) / exact - 1.0);
        std::printf("clamped-pinned at %d nodes: %+.3f %%, prototype %+.2f %%\n", nodes, off, per_cent);
        EXPECT_NEAR(off, per_cent, 0.05 * std::abs(per_cent) + 0.005) << "the prototype's last digit";
    }
}

// ---- In layers ----

constexpr double needle_length = 0.05, needle_radius = 0.3e-3, steel = 2e11;    // [m], [m], [Pa]: the needle of Tables 1 and 2
const double bending = steel * pi * std::pow(needle_radius, 4) / 4.0;           // [N·m²]

struct Stretch {
    double modulus;    // [Pa] of a Winkler foundation
    double part;       // of the needle's length
};
using Layers = std::vector<Stretch>;    // from the free end to the clamp

// The load at which a clamped-free column on this foundation buckles: EI w'''' + P w'' + k w = 0 in each layer, carried on
// exactly from the free end, where w'' and EI w''' + P w' vanish, to the clamp, where w and w' do.
double exact_load(const Layers& layers) {
    using Matrix4 = Eigen::Matrix4d;
    const double scale = bending / (needle_length * needle_length);    // [N]
    const auto clamped = [&](double load) {                            // zero where it buckles; lengths in the needle's
        Eigen::Matrix<double, 4, 2> state;                             // w, w', w'', w'''
        state << 1.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -load / scale;
        for (const Stretch& layer : layers) {
            Matrix4 slope = Matrix4::Zero();
            slope(0, 1) = slope(1, 2) = slope(2, 3) = 1.0;
            slope(3, 0) = -layer.modulus * std::pow(needle_length, 4) / bending;
            slope(3, 2) = -load / scale;
            Matrix4 carried = Matrix4::Identity(), term = Matrix4::Identity();    // the exponential's series
            for (int i = 1; i < 80; ++i) carried += term = term * slope * layer.part / i;
            state = carried * state;
        }
        return state(0, 0) * state(1, 1) - state(0, 1) * state(1, 0);
    };
    const double step = 1e-2 * scale;
    double most = step;
    while ((clamped(most) > 0.0) == (clamped(0.0) > 0.0)) most += step;
    double least = most - step;
    for (int halvings = 0; halvings < 45; ++halvings) {
        const double middle = 0.5 * (least + most);
        ((clamped(middle) > 0.0) == (clamped(0.0) > 0.0) ? least : most) = middle;
    }
    return 0.5 * (least + most);
}

// The foundation's share of each node: its hat function's.
void found(Equilibrium& rod, const Layers& layers) {
    const double edge = rod.chain.edge_length();
    double from_tip = 0.0;    // [m]
    for (const Stretch& layer : layers) {
        const double top = needle_length - from_tip, bottom = std::max(top - layer.part * needle_length, 0.0);    // from the base
        from_tip += layer.part * needle_length;
        for (int e = 0; e < rod.last(); ++e) {
            const double a = std::max(bottom, e * edge), b = std::min(top, (e + 1) * edge);
            if (a >= b) continue;
            const double far = (0.5 * (a + b) - e * edge) / edge;    // mean of the far node's hat
            for (const int side : {x, y}) {
                if (e > 0) rod.springs[rod.unknown(e, side)] += layer.modulus * (b - a) * (1.0 - far);
                rod.springs[rod.unknown(e + 1, side)] += layer.modulus * (b - a) * far;
            }
        }
    }
}

double layered_load(const Layers& layers, int elements) {
    Equilibrium rod({.edges = elements,
                     .length = needle_length,
                     .section = {.stretching = steel * pi * needle_radius * needle_radius,
                                 .bending = {bending, bending},
                                 .twisting = bending / 1.3},
                     .clamped = true,
                     .natural_curvature = std::vector(elements, 0.0)});
    found(rod, layers);
    return critical_load(rod, 150.0);
}

// Moduli that the three homogeneous loads of the paper stand for, soft, middle and stiff.
constexpr double A = 28.525e3, B = 58.236e3, C = 77.327e3;    // [Pa]

struct Row {
    const char* name;
    Layers layers;
    double paper, calibrated;    // [N] printed in the paper, and what these moduli give
};
const std::vector<Row> rows = {
    {"soft all along", {{A, 1.0}}, 6.959, 6.959},
    {"middle all along", {{B, 1.0}}, 9.151, 9.151},
    {"stiff all along", {{C, 1.0}}, 10.289, 10.289},
    {"T1.1", {{A, 0.5}, {B, 0.5}}, 7.000, 7.043},
    {"T1.2", {{B, 0.5}, {A, 0.5}}, 9.001, 8.929},
    {"T1.3", {{A, 0.25}, {B, 0.75}}, 6.994, 7.120},
    {"T1.4", {{B, 0.25}, {A, 0.75}}, 8.659, 8.775},
    {"T1.5", {{A, 0.75}, {B, 0.25}}, 6.909, 6.971},
    {"T1.6", {{B, 0.75}, {A, 0.25}}, 9.058, 9.135},
    {"T2.1", {{A, 0.2}, {B, 0.4}, {C, 0.4}}, 7.179, 7.268},
    {"T2.2", {{C, 0.2}, {B, 0.4}, {A, 0.4}}, 10.078, 9.896},
    {"T2.3", {{A, 0.25}, {B, 0.25}, {C, 0.5}}, 7.172, 7.168},
    {"T2.4", {{C, 0.25}, {B, 0.25}, {A, 0.5}}, 10.337, 9.746},
};

TEST(RodsTangent, HasTheWinklerLoadOfEachLayeredRow) {
    constexpr double wanted = 0.005;     // relative, at 41 nodes
    constexpr double digits = 0.0006;    // [N]
    for (const Row& row : rows) {
        const double exact = exact_load(row.layers), rod = layered_load(row.layers, 40);
        std::printf("%s: paper %.3f N, exact on the foundation %.4f N, rod of 41 nodes %.4f N (%+.2f %%)\n", row.name, row.paper,
                    exact, rod, 100.0 * (rod / exact - 1.0));
        EXPECT_NEAR(exact, row.calibrated, digits) << row.name;
        expect_second_order({{std::string(row.name) + ": Winkler load", exact, wanted * 40.0 * 40.0}},
                            [&](int elements) { return std::vector{only(layered_load(row.layers, elements))}; });
    }
}

TEST(RodsTangent, NearsTheLoadOfALongColumnOnAFoundation) {
    struct Long {
        double length, load, coefficient;    // L (μ/EI)^¼, P/√(μEI)
    };
    for (const Long& column : {Long{2.49, 1.258, 1.0}, Long{4.97, 1.012, 4.0}, Long{9.95, 1.0001, 30.0}}) {
        const double modulus = bending * std::pow(column.length / needle_length, 4);
        const Layers all_along = {{modulus, 1.0}};
        const double scale = std::sqrt(modulus * bending), exact = exact_load(all_along) / scale;
        constexpr double digits = 0.0006;
        EXPECT_NEAR(exact, column.load, digits);
        expect_second_order({{named("long column, %g: load", column.length), exact, column.coefficient}},
                            [&](int elements) { return std::vector{only(layered_load(all_along, elements) / scale)}; });
    }
}

}    // namespace
}    // namespace stylet::rod
