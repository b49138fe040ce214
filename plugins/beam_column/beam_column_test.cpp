#include "sine_curve.h"

#include <stylet/contract/contract.h>
#include <stylet/needle_model.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>

namespace stylet {
namespace {

using beam_column::SineCurve;
using contract::Case;
using std::numbers::pi;

/// Euler's load of a clamped-pinned column, so that this test needs no other plugin.
struct ClampedPinned final : BucklingModel {
    double critical_load(const Column& column) const override {
        const double length = std::max(column.free_length, column.radius);
        return 20.190728556 * column.bending_stiffness / (length * length);
    }
};
const ClampedPinned buckling;

STYLET_CONTRACT(Case{.name = "Straight", .buckling = &buckling, .load = 0.3},
                Case{.name = "Bowed", .buckling = &buckling, .load = 0.8}, Case{.name = "NeverBuckles", .load = 5.0})

const SineCurve curve;

double degrees(double a) {
    return a * pi / 180.0;
}
double shortening(double a) {
    return 1.0 - pi * std::cos(a) / (2.0 * boost::math::ellint_2(std::sin(a)));
}
double load(double a) {
    return std::pow(2.0 * boost::math::ellint_1(std::sin(0.5 * a)) / pi, 2);
}

TEST(SineCurve, IsEquation5OverEquation4) {
    // A thousand cubic pieces: h⁴/384 of the fourth derivative, largest near 89°.
    constexpr double interpolation = 1e-10;
    double worst = 0.0;
    for (double a = 0.05; a < 88.9; a += 0.37) {
        worst = std::max(worst, std::abs(curve.at(shortening(degrees(a))).load / load(degrees(a)) - 1.0));
        worst = std::max(worst, std::abs(curve.largest_slope(shortening(degrees(a))) - degrees(a)));
    }
    std::printf("table against the formula, 0.05 to 89 degrees: %.1e at worst\n", worst);
    EXPECT_LE(worst, interpolation);
}

TEST(SineCurve, HasThePublishedLoads) {
    // validation.md, pinned-pinned post-buckling: the load at an end slope is the elastica's, printed to five digits there.
    constexpr double printed = 5e-6;
    const double slopes[] = {10.0, 20.0, 40.0, 60.0}, loads[] = {1.00382, 1.01540, 1.06366, 1.15172};
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(curve.at(shortening(degrees(slopes[i]))).load, loads[i], printed);
}

TEST(SineCurve, AmplitudeIsOffTheElasticaAsKnown) {
    // paper_findings.md: Eq. (4)'s amplitude, with the span from inextensibility, is off by +0.15 % at F/P = 1.001, 1.5 %
    // at 1.01, 7 % at 1.05, 14 % at 1.1, 26 % at 1.2; two digits are printed there. The elastica's is 2 sin(α/2) / (2K(sin α/2))
    // of the length.
    const double loads[] = {1.001, 1.01, 1.05, 1.1, 1.2}, known[] = {0.0015, 0.015, 0.07, 0.14, 0.26};
    for (int i = 0; i < 5; ++i) {
        double low = 0.0, high = degrees(85.0);
        for (int k = 0; k < 100; ++k) (load(0.5 * (low + high)) < loads[i] ? low : high) = 0.5 * (low + high);
        const double k = std::sin(0.5 * low);
        const double off = SineCurve::amplitude(low) / (k / boost::math::ellint_1(k)) - 1.0;
        std::printf("F/P %.3f: the amplitude of Eq. (4) is off by %+.2f %%\n", loads[i], 100.0 * off);
        EXPECT_NEAR(off, known[i], 0.06 * known[i]);
    }
}

TEST(SineCurve, EnergyIsTheWorkOfTheLoad) {
    // Against an integral of the formula itself over α, which knows no table: ∫ f dη = ηf − ∫ η df.
    const double end = degrees(70.0);
    const auto integrand = [](double a) {
        constexpr double h = 1e-5;
        return load(a) * (shortening(a + h) - shortening(a - h)) / (2.0 * h);
    };
    const double work =
        boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, 1e-4, end, 10, 1e-12) + shortening(1e-4);
    constexpr double differences = 1e-8;    // of the derivative above
    EXPECT_NEAR(curve.at(shortening(end)).energy / work, 1.0, differences);
}

TEST(SineCurve, SlopeIsTheLoadsDerivative) {
    for (const double eta : {1e-4, 0.01, 0.1, 0.3, 0.6, 0.9}) {
        constexpr double h = 1e-6, differences = 1e-6;
        EXPECT_NEAR((curve.at(eta + h).load - curve.at(eta - h).load) / (2.0 * h), curve.at(eta).slope,
                    differences * curve.at(eta).slope);
        EXPECT_NEAR((curve.at(eta + h).energy - curve.at(eta - h).energy) / (2.0 * h), curve.at(eta).load, differences);
    }
    EXPECT_DOUBLE_EQ(curve.at(0.0).load, 1.0);
    EXPECT_DOUBLE_EQ(curve.at(0.0).slope, 0.5);
}

/// A needle straight down, its tip on the surface, pressed by a given force.
struct Pressed {
    explicit Pressed(const Case& with)
        : needle(contract::make<NeedleModel>(STYLET_PLUGIN_FILE, with)), length(with.needle.length) {
        needle->predict({Vector3(0.0, 0.0, length), Quaternion::Identity()}, length, 1e-3);
    }
    /// Returns how many steps it took to balance.
    int press(double newtons) {
        const ContactPoint tip{Vector3::Zero(), Vector3::Zero(), length, true};
        const VectorX force = (VectorX(3) << 0.0, 0.0, newtons).finished();
        for (int step = 1; step <= 50; ++step) {
            (void)needle->linearise({&tip, 1}, 0.0);
            const StepReport report = needle->try_step({&tip, 1}, {force.data(), 3});
            if (report.residual <= 1e-12 && !report.tangent_changed) {
                needle->commit();
                return step;
            }
        }
        return -1;
    }
    std::unique_ptr<NeedleModel> needle;
    double length;
};

const Case with_buckling{.name = "with", .buckling = &buckling};
const Case without_buckling{.name = "without"};

double critical(const Case& with) {
    return buckling.critical_load({.bending_stiffness = with.needle.bending_stiffness(),
                                   .free_length = with.needle.length,
                                   .radius = with.needle.radius,
                                   .ends = with.needle.ends});
}

TEST(BeamColumn, StaysStraightBelowItsCriticalLoadAndNeverAbove) {
    for (int k = 2; k <= 12; ++k) {
        Pressed below(with_buckling), above(with_buckling);
        ASSERT_GT(below.press(critical(with_buckling) * (1.0 - std::pow(10.0, -k))), 0);
        ASSERT_GT(above.press(critical(with_buckling) * (1.0 + std::pow(10.0, -k))), 0);
        EXPECT_FALSE(below.needle->state().buckled);
        EXPECT_EQ(below.needle->state().deflection, 0.0);
        EXPECT_TRUE(above.needle->state().buckled) << "1e-" << k << " above";
        EXPECT_GT(above.needle->state().deflection, 0.0);
    }
}

TEST(BeamColumn, ComesBackStraight) {
    Pressed needle(with_buckling);
    ASSERT_GT(needle.press(1.2 * critical(with_buckling)), 0);
    EXPECT_TRUE(needle.needle->state().buckled);
    ASSERT_GT(needle.press(0.999 * critical(with_buckling)), 0);
    EXPECT_FALSE(needle.needle->state().buckled);
    EXPECT_EQ(needle.needle->energy().stored, 0.0);
    EXPECT_EQ(needle.needle->position(needle.length).z(), 0.0);
}

TEST(BeamColumn, NeverBucklesWithoutABucklingModel) {
    Pressed needle(without_buckling);
    ASSERT_GT(needle.press(1000.0), 0);
    EXPECT_FALSE(needle.needle->state().buckled);
    EXPECT_TRUE(std::isinf(needle.needle->state().critical_load));
}

TEST(BeamColumn, SaysWhenItsSlopePasses45Degrees) {
    const double at_45 = critical(with_buckling) * load(degrees(45.0));
    Pressed below(with_buckling), above(with_buckling);
    ASSERT_GT(below.press(0.999 * at_45), 0);
    ASSERT_GT(above.press(1.001 * at_45), 0);
    EXPECT_EQ(below.needle->beyond_validity(), nullptr);
    EXPECT_NE(above.needle->beyond_validity(), nullptr);
    std::printf("bow at 45 degrees: %.1f %% of the length\n", 100.0 * above.needle->state().deflection / above.length);
}

TEST(BeamColumn, KeepsItsLengthWhileItBows) {
    Pressed needle(with_buckling);
    ASSERT_GT(needle.press(1.05 * critical(with_buckling)), 0);
    constexpr int count = 4001;
    std::vector<Vector3> line(count);
    needle.needle->centreline(line);
    double length = 0.0;
    for (int i = 1; i < count; ++i) length += (line[i] - line[i - 1]).norm();
    // Chords of 4000 pieces fall short of their arcs by (κh)²/24, below 1e-7; the curve's table adds 1e-8.
    EXPECT_NEAR(length / needle.length, 1.0, 3e-7);
    EXPECT_NEAR((line.back() - needle.needle->position(needle.length)).norm(), 0.0, 1e-15);
}

TEST(BeamColumn, EntryForceIsMinusTheEnergysDerivativeInTheFreeLength) {
    Pressed needle(with_buckling);
    ASSERT_GT(needle.press(1.1 * critical(with_buckling)), 0);
    const Pose base{Vector3(0.0, 0.0, needle.length), Quaternion::Identity()};
    const double h = 1e-6 * needle.length;
    needle.needle->predict(base, needle.length + h, 0.0);
    const double longer = needle.needle->energy().stored;
    needle.needle->predict(base, needle.length - h, 0.0);
    const double shorter = needle.needle->energy().stored;
    needle.needle->predict(base, needle.length, 0.0);
    const double force = needle.needle->entry_force();
    std::printf("entry force %.4f N at %.4f N of load\n", force, needle.needle->state().axial_load);
    EXPECT_NEAR(force, -(longer - shorter) / (2.0 * h), 1e-4 * force);    // P_cr' is itself a difference, of 1e-4 of the length
}

}    // namespace
}    // namespace stylet
