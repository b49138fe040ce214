#include "checks.h"
#include "rig.h"

#include <algorithm>
#include <cmath>

namespace stylet::contract {
namespace {

constexpr double definiteness = 1e-12;    // of the largest eigenvalue: rounding of the eigenvalue solver
constexpr double at_rest = 1e-9;          // [m] far below what a hand could place
constexpr double still = 1e-12;           // of the most kinetic energy: a millionth of the fastest
constexpr double same_energy = 1e-9;      // of what is stored: the bodies' own residuals

void compliance_is_not_negative(const Descriptor& plugin, const Case& with) {
    at_both_depths(plugin, with, [](Rig& rig) {
        ASSERT_TRUE(rig.advance(rig.load));
        const Linearisation found = rig.body->linearise(rig.points, 0.0);
        if (found.negatives > 0) return;    // an indefinite compliance that says so is legal
        const VectorX values =
            Eigen::SelfAdjointEigenSolver<MatrixX>(MatrixX(found.compliance), Eigen::EigenvaluesOnly).eigenvalues();
        EXPECT_GT(values.maxCoeff(), 0.0);
        EXPECT_GE(values.minCoeff(), -definiteness * values.maxCoeff());
    });
}

void unloaded_points_rest_where_they_are(const Descriptor& plugin, const Case& with) {
    at_both_depths(plugin, with, [](Rig& rig) {
        const VectorX places = rig.positions(VectorX::Zero(rig.load.size()));
        for (std::size_t i = 0; i < rig.points.size(); ++i) {
            const ContactPoint& point = rig.points[i];
            const Vector3 place = places.segment<3>(3 * i);
            const double length = point.span.squaredNorm();
            const double fraction = length > 0.0 ? std::clamp((place - point.material).dot(point.span) / length, 0.0, 1.0) : 0.0;
            EXPECT_LE((place - point.material - fraction * point.span).norm(), at_rest) << "contact " << i;
        }
    });
}

void unloading_returns_to_rest(const Descriptor& plugin, const Case& with) {
    at_both_depths(plugin, with, [](Rig& rig) {
        const VectorX none = VectorX::Zero(rig.load.size());
        const VectorX before = rig.positions(none);
        const auto away = [&] { return (rig.positions(none) - before).cwiseAbs().maxCoeff(); };
        ASSERT_TRUE(rig.advance(rig.load));
        ASSERT_TRUE(rig.advance(none));
        // An elastic body is there at once; one that swings or remembers is given time.
        double most = 0.0;    // [J] kinetic, so far
        for (int i = 0; i < 20000; ++i) {
            const double kinetic = rig.body->energy().kinetic;
            most = std::max(most, kinetic);
            if (kinetic <= still * most && away() <= at_rest) break;
            (void)rig.advance(none);
        }
        EXPECT_LE(away(), at_rest);
    });
}

/// Core solves again at one instant wherever a contact has moved, so nothing may creep or swing on there.
void stands_still_at_one_instant(const Descriptor& plugin, const Case& with) {
    at_both_depths(plugin, with, [](Rig& rig) {
        for (int i = 1; i <= 4; ++i) ASSERT_TRUE(rig.advance(0.25 * i * rig.load));
        const VectorX before = rig.positions(rig.load);
        const EnergyReport energy = rig.body->energy();
        rig.tissue->predict(0.0);
        ASSERT_TRUE(rig.converge(rig.load));
        EXPECT_LE((rig.positions(rig.load) - before).cwiseAbs().maxCoeff(), at_rest);
        EXPECT_NEAR(rig.body->energy().stored, energy.stored, same_energy * energy.stored);
        EXPECT_EQ(rig.body->energy().damping, energy.damping);
        EXPECT_EQ(rig.body->energy().numerical, energy.numerical);
    });
}

void locates_its_layers(const Descriptor& plugin, const Case& with) {
    const auto object = make(plugin, with);
    const auto& tissue = static_cast<const TissueModel&>(*object);
    const auto layer_at = [&tissue](double z) { return tissue.locate(Vector3(0.0, 0.0, z)).layer; };
    EXPECT_EQ(tissue.locate(Vector3::Zero()).depth, 0.0);
    EXPECT_EQ(layer_at(0.0), 0) << "the surface belongs to the first layer";
    EXPECT_EQ(layer_at(1e-3), outside);
    EXPECT_LT(tissue.locate(Vector3(0.0, 0.0, 1e-3)).depth, 0.0);
    EXPECT_EQ(layer_at(-with.tissue.extent.z() - 1e-3), outside) << "below the bottom";
    EXPECT_EQ(tissue.locate(Vector3(with.tissue.extent.x(), 0.0, -1e-3)).layer, outside) << "beside the block";
    double depth = 0.0;    // [m] of the lower border of the layers so far
    for (std::size_t i = 0; i + 1 < with.tissue.layers.size(); ++i) {
        depth += with.tissue.layers[i].thickness;
        const int layer = static_cast<int>(i);
        EXPECT_EQ(layer_at(std::nextafter(-depth, 0.0)), layer);
        EXPECT_EQ(layer_at(-depth), layer + 1) << "an interface belongs to the layer below it";
        EXPECT_EQ(layer_at(std::nextafter(-depth, -1.0)), layer + 1);
    }
}

void finds_where_a_way_enters(const Descriptor& plugin, const Case& with) {
    constexpr double tolerance = 1e-12;    // of the way: rounding
    const auto object = make(plugin, with);
    const auto& tissue = static_cast<const TissueModel&>(*object);
    const Vector3 above(0.0, 0.0, 1e-3);
    EXPECT_NEAR(tissue.entry(above, Vector3(0.0, 0.0, -1e-3)), 0.5, tolerance);
    EXPECT_NEAR(tissue.entry(above, Vector3(1e-3, 0.0, -3e-3)), 0.25, tolerance);
    EXPECT_EQ(tissue.entry(above, Vector3(2e-3, 0.0, 1e-6)), -1.0);
    EXPECT_EQ(tissue.entry(above, above), -1.0);
}

void starts_within_its_validity(const Descriptor& plugin, const Case& with) {
    const auto object = make(plugin, with);
    EXPECT_EQ(static_cast<const TissueModel&>(*object).beyond_validity(), nullptr);
}

}    // namespace

std::vector<Check> tissue_checks() {
    std::vector<Check> checks = body_checks();
    checks.insert(checks.end(), {{"ComplianceIsNotNegative", compliance_is_not_negative},
                                 {"UnloadedPointsRestWhereTheyAre", unloaded_points_rest_where_they_are},
                                 {"UnloadingReturnsToRest", unloading_returns_to_rest},
                                 {"StandsStillAtOneInstant", stands_still_at_one_instant},
                                 {"LocatesItsLayers", locates_its_layers},
                                 {"FindsWhereAWayEnters", finds_where_a_way_enters},
                                 {"StartsWithinItsValidity", starts_within_its_validity}});
    return checks;
}

}    // namespace stylet::contract
