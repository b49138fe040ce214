// The chain at rest against exact solutions of thin rods: cantilevers, bowed columns, a rolled-up rod. Of unit length and bending
// stiffness, all but unstretchable.
#include "convergence.h"
#include "equilibrium.h"
#include "known_rods.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace stylet::rod {
namespace {

using std::numbers::pi;
constexpr int x = Equilibrium::x, y = Equilibrium::y, z = Equilibrium::z;

// Reach and drop of a tip that is pulled toward x.
VectorX reach_and_drop(const Equilibrium& rod) {
    const Vector3 tip = rod.place(rod.last());
    return Eigen::Vector2d(-tip.z(), tip.x());
}

// The protocol of Romero et al. 2021. The heavier, the shorter the bend at the clamp, (EI/w)^(1/3): 0.1 L in the last row.
TEST(RodAtRest, HangsAsAHeavyCantileverDoes) {
    struct Row {
        double weight, published, coefficient;    // wL³/EI, drop over reach
    };
    for (const Row& row : {Row{0.1, 0.0125, 1.1}, Row{1.0, 0.1246, 1.0}, Row{3.0, 0.3646, 0.8}, Row{5.0, 0.5857, 0.4},
                           Row{10.0, 1.0668, 0.7}, Row{20.0, 1.864, 2.4}, Row{50.0, 3.706, 6.5}, Row{100.0, 5.888, 13.0},
                           Row{200.0, 8.907, 25.0}, Row{500.0, 14.77, 62.0}, Row{1000.0, 21.34, 120.0}}) {
        const Hanging exact = hanging([&](double u) { return row.weight * u; });
        constexpr double digits = 6e-4;    // relative: three or four are printed
        EXPECT_NEAR(exact.drop / exact.reach, row.published, digits * row.published);
        const auto hang = [&](int elements) {
            Equilibrium rod(unit_rod(elements, true, row.weight));
            constexpr int steps = 10;
            for (int step = 1; step <= steps; ++step) {
                for (int node = 1; node <= elements; ++node)
                    rod.load[rod.unknown(node, x)] =
                        row.weight * step / steps * rod.chain.edge_length() * (node == elements ? 0.5 : 1.0);
                EXPECT_TRUE(rod.solve());
            }
            const VectorX tip = reach_and_drop(rod);
            return std::vector{only(tip[1] / tip[0])};
        };
        expect_second_order(
            {{named("heavy cantilever %g: drop over reach", row.weight), exact.drop / exact.reach, row.coefficient}}, hang, 640);
    }
}

TEST(RodAtRest, BendsUnderATransverseTipLoad) {
    struct Row {
        double load, drop, reach, coefficient;    // PL²/EI
    };
    for (const Row& row : {Row{0.5, 0.16214, 0.98408, 0.08}, Row{1.0, 0.30172, 0.94357, 0.11}, Row{2.0, 0.49346, 0.83936, 0.1},
                           Row{5.0, 0.71379, 0.61237, 0.32}, Row{10.0, 0.81061, 0.44500, 0.6}}) {
        const Hanging exact = hanging([&](double) { return row.load; });
        constexpr double digits = 6e-6;
        EXPECT_NEAR(exact.drop, row.drop, digits);
        EXPECT_NEAR(exact.reach, row.reach, digits);
        expect_second_order({{named("tip load %g: tip", row.load), Eigen::Vector2d(exact.reach, exact.drop), row.coefficient}},
                            [&](int elements) {
                                Equilibrium rod(unit_rod(elements, true, row.load));
                                rod.load[rod.unknown(elements, x)] = row.load;
                                EXPECT_TRUE(rod.solve());
                                return std::vector{reach_and_drop(rod)};
                            });
    }
}

// Timoshenko's tip without its shear: FL³/3EI, which a load of 1e-4 EI/L² bends linearly to 1e-9.
TEST(RodAtRest, DeflectsAsBernoullisBeamUnderALightLoad) {
    constexpr double load = 1e-4;
    expect_second_order({{"light tip load: FL^3/3EI", load / 3.0, 0.6}}, [](int elements) {
        Equilibrium rod(unit_rod(elements, true, 0.0));
        rod.load[rod.unknown(elements, y)] = load;
        EXPECT_TRUE(rod.solve());
        return std::vector{only(rod.place(elements).y())};
    });
}

struct Bowed {
    double slope, load, deflection, span, pinned, clamped;    // [deg], of the critical load, of L; the error's coefficient
};
constexpr Bowed published[] = {{10.0, 1.00382, .05538, .99240, 0.7, 0.2},  {20.0, 1.01540, .10971, .96973, 0.6, 0.2},
                               {40.0, 1.06366, .21112, .88120, 0.5, 0.15}, {60.0, 1.15172, .29660, .74102, 1.8, 0.5},
                               {90.0, 1.39320, .38138, .45695, 5.0, 1.4},  {120.0, 1.88480, .40159, .12316, 12.0, 3.0}};
constexpr double digits = 6e-6;

TEST(RodAtRest, BowsAsAPinnedColumnDoes) {
    for (const Bowed& row : published) {
        const Bow exact = pinned_pinned(row.slope * pi / 180.0);
        EXPECT_NEAR(exact.load / (pi * pi), row.load, digits);
        EXPECT_NEAR(exact.deflection, row.deflection, digits);
        EXPECT_NEAR(exact.span, row.span, digits);
        const auto push = [&](int elements) {
            Equilibrium rod(unit_rod(elements, false, exact.load));
            pin_tip(rod);
            EXPECT_TRUE(bow(rod, elements / 2, exact.span));
            EXPECT_EQ(rod.negatives(), 0);
            return std::vector<VectorX>{Eigen::Vector2d(rod.reaction(rod.unknown(elements, z)) / exact.load,
                                                        rod.place(elements / 2).x() / exact.deflection)};
        };
        expect_second_order(
            {{named("pinned-pinned, %g degrees: load, deflection", row.slope), VectorX(VectorX::Ones(2)), row.pinned}}, push, 80);
    }
}

TEST(RodAtRest, BowsAsAClampedFreeColumnDoes) {
    for (const Bowed& row : published) {
        const Bow exact = clamped_free(row.slope * pi / 180.0);
        const auto push = [&](int elements) {
            Equilibrium rod(unit_rod(elements, true, exact.load));
            EXPECT_TRUE(bow(rod, elements, exact.span));
            EXPECT_EQ(rod.negatives(), 0);
            return std::vector<VectorX>{
                Eigen::Vector2d(rod.reaction(rod.unknown(elements, z)) / exact.load, rod.place(elements).x() / exact.deflection)};
        };
        expect_second_order(
            {{named("clamped-free, %g degrees: load, deflection", row.slope), VectorX(VectorX::Ones(2)), row.clamped}}, push, 80);
    }
}

// −M β, with β the angle of the last edge in the plane of x and z: a moment, as the couple of forces M/|e| across its two nodes.
void add_moment(double moment, const Chain& chain, const Shape& shape, VectorX& gradient, BandLdlt& tangent) {
    const int far = Chain::unknown_of(chain.edges()), near = Chain::unknown_of(chain.edges() - 1);
    const Vector3 edge =
        chain.edge_length() * Chain::axis + shape.displacement[chain.edges()] - shape.displacement[chain.edges() - 1];
    const double across = edge.x(), along = -edge.z(), square = across * across + along * along;
    const double turn[2] = {-moment * along / square, -moment * across / square};    // by x and by z
    const double xx = 2.0 * moment * across * along / (square * square);
    const double xz = moment * (across * across - along * along) / (square * square);
    const double second[2][2] = {{xx, xz}, {xz, -xx}};
    for (int i = 0; i < 2; ++i) {
        gradient[far + 2 * i] += turn[i];
        gradient[near + 2 * i] -= turn[i];
        for (int j = 0; j < 2; ++j) {
            tangent.add(far + 2 * i, near + 2 * j, -second[i][j]);
            if (j > i) continue;
            tangent.add(far + 2 * i, far + 2 * j, second[i][j]);
            tangent.add(near + 2 * i, near + 2 * j, second[i][j]);
        }
    }
}

TEST(RodAtRest, RollsUpToACircleUnderAnEndMoment) {
    const auto roll = [](int elements) {
        Equilibrium rod(unit_rod(elements, true, 0.0));
        for (int node = 1; node <= elements; ++node) rod.held[rod.unknown(node, y)] = 0.0;
        double moment = 0.0;
        rod.further = [&](const Shape& shape, VectorX& gradient, BandLdlt& tangent) {
            add_moment(moment, rod.chain, shape, gradient, tangent);
        };
        constexpr int steps = 16;
        for (int step = 1; step <= steps; ++step) {
            moment = 2.0 * pi * step / steps;
            EXPECT_TRUE(rod.solve());
        }
        return std::vector{VectorX(rod.place(elements))};
    };
    expect_second_order({{"roll-up by M = 2 pi EI/L: gap", VectorX(VectorX::Zero(3)), 25.0}}, roll);
}

}    // namespace
}    // namespace stylet::rod
