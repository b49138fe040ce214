// The chain at rest under loads across it, in a foundation, out of a plane, and about to twist away.
#include "convergence.h"
#include "equilibrium.h"

#include <boost/math/special_functions/bessel.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace stylet::rod {
namespace {

using std::numbers::pi;
constexpr int x = Equilibrium::x, y = Equilibrium::y, z = Equilibrium::z;

// ---- On a Winkler foundation: EI w'''' + μ w = 0, with λ = (μ/4EI)^¼ ----

// The needle and the foundation of validation's row: λ = 35.18 /m.
constexpr double bending = 1.2723e-3;    // [N·m²]
constexpr double foundation = 7792.5;    // [Pa]
constexpr double sideways = 1e-3;        // [N] so little that slopes square to 1e-7

// A wave to the far end and back has lost all but e^-11 = 2e-5 of itself.
constexpr double decay_lengths = 5.5;

// A needle all in the foundation, as many decay lengths long, as a spring at each node for the foundation that is nearest.
Equilibrium embedded(double lengths, int elements) {
    const double length = lengths / std::pow(foundation / (4.0 * bending), 0.25);
    Equilibrium rod({.edges = elements,
                     .length = length,
                     .section = {.stretching = 5.65e4, .bending = {bending, bending}, .twisting = bending / 1.3},
                     .clamped = true,
                     .natural_curvature = std::vector(elements, 0.0)});
    for (int node = 1; node <= elements; ++node) {
        for (const int side : {x, y})
            rod.springs[rod.unknown(node, side)] = foundation * rod.chain.edge_length() * (node == elements ? 0.5 : 1.0);
    }
    return rod;
}

TEST(RodInAFoundation, GivesWayToASidewaysLoadAtItsEnd) {
    const double lambda = std::pow(foundation / (4.0 * bending), 0.25);
    EXPECT_NEAR(lambda, 35.18, 0.005);
    EXPECT_NEAR(2.0 * 0.1 * lambda / foundation, 0.903e-3, 0.0005e-3);
    expect_second_order(
        {{"free end: 2 F lambda/mu", 2.0 * sideways * lambda / foundation, 7.8}},
        [](int elements) {
            Equilibrium rod = embedded(decay_lengths, elements);
            rod.load[rod.unknown(elements, x)] = sideways;
            EXPECT_TRUE(rod.solve());
            return std::vector{only(rod.displacement(elements, x))};
        },
        80);
}

TEST(RodInAFoundation, GivesWayToASidewaysLoadFarFromItsEnds) {
    const double lambda = std::pow(foundation / (4.0 * bending), 0.25);
    expect_second_order(
        {{"infinite beam: F lambda/2 mu", 0.5 * sideways * lambda / foundation, 7.8}},
        [](int elements) {
            Equilibrium rod = embedded(2.0 * decay_lengths, 2 * elements);    // as many to each side
            rod.load[rod.unknown(elements, x)] = sideways;
            EXPECT_TRUE(rod.solve());
            return std::vector{only(rod.displacement(elements, x))};
        },
        80);
}

// ---- Lateral-torsional buckling of a blade: it bends by the stiff way, and leaves it by the soft one and by twisting ----

constexpr double soft = 1.0, twisting = 0.7;    // [N·m²] of a unit length
// So stiff that bending before it buckles (by a factor of √(1 − 1e-6)) does not count.
constexpr double stiff = 1e6;

// The load at which it first leaves its plane, by halving between one at which it does not and one at which it does.
template <class Load>
double leaves_its_plane(int elements, double least, double most, Load put) {
    Equilibrium rod({.edges = elements,
                     .length = 1.0,
                     .section = {.stretching = 1e8, .bending = {stiff, soft}, .twisting = twisting},
                     .clamped = true,
                     .natural_curvature = std::vector(elements, 0.0)});
    for (int halvings = 0; halvings < 40; ++halvings) {
        const double middle = 0.5 * (least + most);
        put(rod, middle);
        EXPECT_TRUE(rod.solve());
        (rod.negatives() > 0 ? most : least) = middle;
    }
    return 0.5 * (least + most);
}

// Source: Timoshenko and Gere 1961, sections 6.3 and 6.4: the first zeros of two Bessel functions.
TEST(Blade, BucklesSidewaysUnderATipLoad) {
    const double exact = 2.0 * boost::math::cyl_bessel_j_zero(-0.25, 1) * std::sqrt(soft * twisting);
    EXPECT_NEAR(exact / std::sqrt(soft * twisting), 4.0126, 5e-5);
    expect_second_order({{"blade: tip load", exact, 0.55}}, [](int elements) {
        return std::vector{only(leaves_its_plane(
            elements, 1.0, 5.0, [](Equilibrium& rod, double load) { rod.load[rod.unknown(rod.last(), x)] = load; }))};
    });
}

TEST(Blade, BucklesSidewaysUnderItsOwnWeight) {
    const double exact = 6.0 * boost::math::cyl_bessel_j_zero(-1.0 / 6.0, 1) * std::sqrt(soft * twisting);
    EXPECT_NEAR(exact / std::sqrt(soft * twisting), 12.854, 5e-4);
    expect_second_order({{"blade: own weight", exact, 1.1}}, [](int elements) {
        return std::vector{only(leaves_its_plane(elements, 5.0, 15.0, [](Equilibrium& rod, double weight) {
            for (int node = 1; node <= rod.last(); ++node)
                rod.load[rod.unknown(node, x)] = weight * rod.chain.edge_length() * (node == rod.last() ? 0.5 : 1.0);
        }))};
    });
}

// ---- An eighth of a circle of radius 100, clamped, loaded by 600 out of its plane; E = 1e7, ν = 0, a section of 1 by 1 ----

VectorX bathes_tip(int elements) {
    constexpr double modulus = 1e7, radius = 100.0, load = 600.0, second_moment = 1.0 / 12.0;
    // Twisting by the polar second moment, as those do who published tips.
    Equilibrium rod({.edges = elements,
                     .length = 0.25 * pi * radius,
                     .section = {.stretching = modulus,
                                 .bending = {modulus * second_moment, modulus * second_moment},
                                 .twisting = 0.5 * modulus * 2.0 * second_moment},
                     .clamped = true,
                     .natural_curvature = std::vector(elements, 1.0 / radius)});
    constexpr int steps = 8;
    for (int step = 0; step <= steps; ++step) {
        rod.load[rod.unknown(elements, y)] = load * step / steps;
        EXPECT_TRUE(rod.solve());
    }
    const Vector3 tip = rod.place(elements);
    return Vector3(tip.x(), -tip.z(), tip.y());    // toward the centre, along the clamp, out of the plane
}

// Source: Bathe and Bolourchi 1979. Published tips, most of them of rods that shear, spread by 1 %.
TEST(RodAtRest, BendsOutOfThePlaneOfItsArc) {
    const Vector3 published(15.8, 47.2, 53.4);
    const VectorX converged = (4.0 * bathes_tip(320) - bathes_tip(160)) / 3.0;
    std::printf("45 degree bend: tip %.3f %.3f %.3f, published %.1f %.1f %.1f\n", converged[0], converged[1], converged[2],
                published[0], published[1], published[2]);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(converged[i], published[i], 0.01 * published[i]);
    expect_second_order(
        {{"45 degree bend: tip", converged, 0.4}}, [](int elements) { return std::vector{bathes_tip(elements)}; }, 80);
}

}    // namespace
}    // namespace stylet::rod
