// The chain's derivatives against differences of what they are derivatives of, and what turning it as a whole does.
#include "chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace stylet::rod {
namespace {

using std::numbers::pi;

const Viscosity none{.rate = 0.0, .before = nullptr};

ChainSetup six_edges(bool clamped, bool curved = true) {
    return {.edges = 6,
            .length = 0.6,
            .section = {.stretching = 50.0, .bending = {1.3, 0.7}, .twisting = 0.9},
            .clamped = clamped,
            .natural_curvature = curved ? std::vector{1.0, 2.0, -1.0, 0.5, 0.3, 0.2} : std::vector(6, 0.0)};
}

// A chain that `size` [1] bends, twists and stretches, at 1 by a radian or so from edge to edge.
Shape random_shape(const Chain& chain, double size, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    Shape shape = chain.straight();
    VectorX dx(chain.unknowns());
    for (int steps = 0; steps < 5; ++steps) {
        for (int a = 0; a < dx.size(); ++a) dx[a] = size * any(generator) * (a % 4 == 3 ? 0.3 : 0.3 * chain.edge_length());
        chain.move(dx, shape);
    }
    return shape;
}

Shape moved(const Chain& chain, Shape shape, const VectorX& dx) {
    chain.move(dx, shape);
    return shape;
}

VectorX gradient_of(const Chain& chain, const Shape& shape) {
    VectorX gradient(chain.unknowns());
    chain.gradient(shape, none, gradient);
    return gradient;
}

// The derivative of `f` along each unknown, by central differences of fourth order.
template <class Value>
std::vector<Value> slopes(const Chain& chain, const Shape& shape, Value (*f)(const Chain&, const Shape&)) {
    std::vector<Value> found;
    for (int a = 0; a < chain.unknowns(); ++a) {
        const double h = a % 4 == 3 ? 1e-3 : 1e-3 * chain.edge_length();
        const auto at = [&](double steps) {
            VectorX dx = VectorX::Zero(chain.unknowns());
            dx[a] = steps * h;
            return f(chain, moved(chain, shape, dx));
        };
        found.push_back(Value((8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * h)));
    }
    return found;
}

double energy_of(const Chain& chain, const Shape& shape) {
    return chain.energy(shape);
}

MatrixX tangent_of(const Chain& chain, const Shape& shape) {
    BandLdlt band(chain.unknowns());
    std::vector<double> tensions;
    for (int e = 0; e < chain.edges(); ++e) tensions.push_back(chain.tension(shape, e));
    VectorX gradient(chain.unknowns());
    chain.linearise(shape, tensions, none, band, gradient);
    MatrixX tangent = MatrixX::Zero(chain.unknowns(), chain.unknowns());
    for (int j = 0; j < chain.unknowns(); ++j) {
        for (int i = j; i < std::min(j + BandLdlt::band + 1, chain.unknowns()); ++i)
            tangent(i, j) = tangent(j, i) = band.at(i, j);
    }
    return tangent;
}

Matrix3 cross(const Vector3& v) {
    Matrix3 m;
    m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    return m;
}

/// How much a chain is bent, twisted and stretched; see random_shape().
class ChainBentBy : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Decades, ChainBentBy, testing::Values(1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1.0));

// Relative. Steps of h = 1e-3 leave h⁴/30 of a fifth derivative, which is 1e-12 but where edges are bent by a radian, and
// rounding of 1e-16/h.
constexpr double differences = 1e-9;

TEST_P(ChainBentBy, HasAGradientThatIsTheSlopeOfItsEnergy) {
    for (const auto& [clamped, curved] : {std::pair{true, true}, {true, false}, {false, true}, {false, false}}) {
        const Chain chain(six_edges(clamped, curved));
        const Shape shape = random_shape(chain, GetParam(), 7);
        const VectorX gradient = gradient_of(chain, shape);
        const std::vector<double> slope = slopes<double>(chain, shape, energy_of);
        double worst = 0.0;
        for (int a = 0; a < chain.unknowns(); ++a) worst = std::max(worst, std::abs(slope[a] - gradient[a]));
        std::printf("bent by %g, %s, naturally %s: gradient %.3g, off the energy's slope by %.1e of it\n", GetParam(),
                    clamped ? "clamped" : "pinned", curved ? "curved" : "straight", gradient.norm(), worst / gradient.norm());
        EXPECT_LE(worst, differences * gradient.norm());
    }
}

// Directors that are carried along by the shortest way are no coordinates: an edge that is moved by u and then by v has its
// material turned, against one that is moved by v and then by u, by the solid angle that it has gone round, t·(u × v)/|e|². So
// second differences of the energy differ by that times the edge's torque ∂U/∂θ when they are taken in the other order, and
// only where no torque is left do they have to be symmetric. The tangent is their symmetric part, which is all that Newton's
// method needs, and exact at rest.
TEST_P(ChainBentBy, HasATangentThatIsTheSymmetricPartOfItsGradientsSlope) {
    const Chain chain(six_edges(true));
    const Shape shape = random_shape(chain, GetParam(), 11);
    const std::vector<VectorX> columns = slopes<VectorX>(chain, shape, gradient_of);
    MatrixX slope(chain.unknowns(), chain.unknowns());
    for (int a = 0; a < chain.unknowns(); ++a) slope.col(a) = columns[a];
    const MatrixX tangent = tangent_of(chain, shape), symmetric = 0.5 * (slope + slope.transpose());
    const double scale = tangent.cwiseAbs().maxCoeff();
    const double worst = (tangent - symmetric).cwiseAbs().maxCoeff() / scale;

    const VectorX gradient = gradient_of(chain, shape);
    MatrixX turned = MatrixX::Zero(chain.unknowns(), chain.unknowns());
    for (int e = 0; e < chain.edges(); ++e) {
        const Vector3 edge = chain.edge_length() * Chain::axis + shape.displacement[e + 1] - shape.displacement[e];
        const Matrix3 solid = 0.5 * gradient[Chain::unknown_of(e + 1) + 3] * cross(edge.normalized()) / edge.squaredNorm();
        const int far = Chain::unknown_of(e + 1), near = Chain::unknown_of(e);
        turned.block<3, 3>(far, far) += solid;
        if (e == 0) continue;
        turned.block<3, 3>(near, near) += solid;
        turned.block<3, 3>(near, far) -= solid;
        turned.block<3, 3>(far, near) -= solid;
    }
    const MatrixX antisymmetric = 0.5 * (slope - slope.transpose());
    const double off = (antisymmetric - turned).cwiseAbs().maxCoeff() / scale;
    std::printf("bent by %g: tangent off by %.1e of its largest entry; asymmetry %.1e, off the solid angles' by %.1e\n",
                GetParam(), worst, antisymmetric.cwiseAbs().maxCoeff() / scale, off);
    EXPECT_LE(worst, differences);
    EXPECT_LE(off, differences);
}

// Half of what a step of damping dissipates is a potential of its moments: ½ rate Σ B (κ − before)²/ℓj.
TEST_P(ChainBentBy, HasViscousMomentsThatAreTheSlopeOfHalfTheirDissipation) {
    static constexpr double rate = 3.0;
    static std::vector<Strain> before;    // shared with `half`, which has to be a plain function
    for (const bool clamped : {true, false}) {
        const Chain chain(six_edges(clamped));
        const Shape from = random_shape(chain, GetParam(), 23), shape = random_shape(chain, GetParam(), 29);
        before.clear();
        for (int joint = 0; joint < chain.edges(); ++joint) before.push_back(chain.strain(from, joint));
        const auto half = [](const Chain& of, const Shape& at) {
            double sum = 0.0;
            for (int joint = 0; joint < of.edges(); ++joint) {
                const Strain change = of.strain(at, joint) - before[joint];
                sum += 0.5 * rate * of.bending_and_twisting(joint).dot(change.cwiseAbs2());
            }
            return sum;
        };
        VectorX gradient(chain.unknowns());
        chain.gradient(shape, {.rate = rate, .before = &before}, gradient);
        const VectorX viscous = gradient - gradient_of(chain, shape);
        const std::vector<double> slope = slopes<double>(chain, shape, half);
        for (int a = 0; a < chain.unknowns(); ++a) EXPECT_NEAR(slope[a], viscous[a], 10.0 * differences * gradient.norm()) << a;
    }
}

TEST_P(ChainBentBy, HasNoMomentAboutAnUntwistedHinge) {
    const Chain chain(six_edges(false));
    Shape shape = random_shape(chain, GetParam(), 13);
    shape.angle[0] = 0.0;    // the base holds the spin, so it must not be wound up
    const VectorX gradient = gradient_of(chain, shape);
    for (int direction = 0; direction < 3; ++direction) {
        const Vector3 axis = Vector3::Unit(direction);
        double work = 0.0;    // [N·m] per radian
        for (int node = 1; node < chain.nodes(); ++node) {
            const Vector3 place = node * chain.edge_length() * Chain::axis + shape.displacement[node];
            const Vector3 edge = chain.edge_length() * Chain::axis + shape.displacement[node] - shape.displacement[node - 1];
            work += gradient.segment<3>(Chain::unknown_of(node)).dot(axis.cross(place)) +
                    gradient[Chain::unknown_of(node) + 3] * axis.dot(edge.normalized());
        }
        constexpr double rounding = 1e-12;    // of the forces times the length
        EXPECT_LE(std::abs(work), rounding * std::max(1.0, gradient.norm())) << "about axis " << direction;
    }
}

// Turns nodes and materials about an axis through the base.
void turn(const Chain& chain, const Vector3& axis, double angle, Shape& shape) {
    const Matrix3 rotation = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    const auto material = [&](int e) -> Vector3 {
        const Vector3 edge = chain.edge_length() * Chain::axis + shape.displacement[e + 1] - shape.displacement[e];
        return std::cos(shape.angle[e]) * shape.reference[e] +
               std::sin(shape.angle[e]) * edge.normalized().cross(shape.reference[e]);
    };
    std::vector<Vector3> wanted;
    VectorX dx = VectorX::Zero(chain.unknowns());
    for (int e = 0; e < chain.edges(); ++e) {
        wanted.push_back(rotation * material(e));
        const Vector3 place = (e + 1) * chain.edge_length() * Chain::axis + shape.displacement[e + 1];
        dx.segment<3>(Chain::unknown_of(e + 1)) = rotation * place - place;
    }
    chain.move(dx, shape);
    dx.setZero();
    for (int e = 0; e < chain.edges(); ++e) {
        const Vector3 edge = chain.edge_length() * Chain::axis + shape.displacement[e + 1] - shape.displacement[e];
        const Vector3 is = material(e);
        dx[Chain::unknown_of(e + 1) + 3] = std::atan2(edge.normalized().dot(is.cross(wanted[e])), is.dot(wanted[e]));
    }
    chain.move(dx, shape);
}

constexpr int turns = 36;             // in a full turn
constexpr double gathered = 1e-10;    // relative, and [rad]: rounding of that many moves of six edges

// The base holds the twist of the first edge, so turned about any axis that lies across it nothing is wound up.
TEST(Chain, KeepsItsEnergyWhenItSwingsOnItsHinge) {
    const Chain straight(six_edges(false, false));
    Shape shape = straight.straight();
    for (int i = 0; i < turns; ++i) {
        turn(straight, Vector3::UnitY(), 2.0 * pi / turns, shape);
        ASSERT_LE(straight.energy(shape), gathered) << "a straight chain that swung by " << 360 * (i + 1) / turns << " degrees";
    }

    const Chain chain(six_edges(false));
    Shape bent = random_shape(chain, 0.5, 17);
    bent.angle[0] = 0.0;
    const double before = chain.energy(bent);
    const Vector3 edge = chain.edge_length() * Chain::axis + bent.displacement[1];
    const Vector3 across = Chain::axis.cross(edge).normalized();    // so that the first edge swings in the plane of the hinge
    for (int i = 0; i < turns / 4; ++i) turn(chain, across, 2.0 * pi / turns, bent);
    EXPECT_NEAR(chain.energy(bent), before, gathered * before);
}

// Hard case 39: what the base does when a hand rolls it, seen from the base.
TEST(Chain, IsWoundUpWithoutAJumpWhenItsBaseIsRolledAllRound) {
    const Chain chain(six_edges(true));
    Shape shape = random_shape(chain, 0.5, 19);
    // So far off the axis that in one turn the first edge's reference goes round its own by 2π (1 − cos 80°).
    for (int i = 0; i < 8; ++i) turn(chain, Vector3::UnitY(), pi / 18.0, shape);
    const double before = chain.strain(shape, 0)[2];
    for (int i = 1; i <= 2 * turns; ++i) {
        turn(chain, Chain::axis, 2.0 * pi / turns, shape);
        const double twist = chain.strain(shape, 0)[2], wound = before + 2.0 * pi * i / turns;
        ASSERT_NEAR(twist, wound, gathered) << "after " << 360 * i / turns << " degrees";
    }
}

}    // namespace
}    // namespace stylet::rod
