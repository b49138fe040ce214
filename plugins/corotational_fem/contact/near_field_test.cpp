#include "contact/near_field.h"

#include "contact/test_needles.h"
#include "mesh/locator.h"

#include <stylet/contract/allocations.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ostream>
#include <random>

namespace stylet::corotational_fem {
namespace {

using namespace testing;

constexpr double youngs_modulus = 25e3;    // [Pa]
constexpr double radius = 0.3e-3;          // [m] of the needle
constexpr double piece = 5e-3;             // [m] of shaft for each contact
const Vector3 entry(1.3e-3, 0.7e-3, 0.0), down(0.0, 0.0, -1.0), slanting(1.0, 0.3, -1.5);

Needled gel(const Vector3& extent, const std::array<int, 3>& cells, double poisson_ratio, bool share_pressure) {
    const TissueSetup tissue = block_of(extent, youngs_modulus, poisson_ratio);
    return {tissue, block_mesh(tissue, cells), radius, share_pressure};
}

Needled workload(double poisson_ratio, bool share_pressure) {
    return gel({0.1, 0.1, 0.05}, {11, 11, 7}, poisson_ratio, share_pressure);
}

double smallest_eigenvalue(const MatrixX& matrix) {
    return Eigen::SelfAdjointEigenSolver<MatrixX>(matrix, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

/// The largest over the least, less one.
double spread_of(const std::vector<double>& values) {
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    return *greatest / *least - 1.0;
}

struct Pressed {
    double poisson_ratio;
    bool share_pressure;

    friend std::ostream& operator<<(std::ostream& stream, const Pressed& pressed) {
        return stream << "nu " << pressed.poisson_ratio << " pressure by " << (pressed.share_pressure ? "patch" : "tetrahedron");
    }
};

class ForceAgainstDepth : public ::testing::TestWithParam<Pressed> {};
INSTANTIATE_TEST_SUITE_P(Pressures, ForceAgainstDepth,
                         ::testing::Values(Pressed{0.45, false}, Pressed{0.45, true}, Pressed{0.49, false}, Pressed{0.49, true}),
                         [](const auto& given) {
                             return std::string(given.param.poisson_ratio == 0.45 ? "Nu45" : "Nu49") +
                                    (given.param.share_pressure ? "Patch" : "Tetrahedron");
                         });

TEST_P(ForceAgainstDepth, DoesNotDependOnTheMesh) {
    constexpr double wanted = 0.05;    // what is asked of three mesh sizes; most are within 2 %
    const auto [nu, share_pressure] = GetParam();
    const Vector3 extent(0.1, 0.1, 0.05);
    std::array<Needled, 3> blocks = {gel(extent, {6, 6, 5}, nu, share_pressure), gel(extent, {11, 11, 7}, nu, share_pressure),
                                     gel(extent, {15, 15, 10}, nu, share_pressure)};
    std::printf("nu %.2f, pressure by %s; compliances [mm/N] on 6x6x5, 11x11x7, 15x15x10 (half_space)\n", nu,
                share_pressure ? "patch" : "tetrahedron");
    for (const Vector3& direction : {down, slanting}) {
        for (const double length : {0.0, 2e-3, 5e-3, 10e-3, 20e-3, 30e-3}) {
            const Points points = needle(entry, direction, length, piece);
            const MatrixX flat = half_space(points, youngs_modulus, nu, radius);
            std::printf("%s %2.0f mm:", direction == down ? "upright " : "slanting", 1e3 * length);
            for (const int axis : {2, 0}) {
                std::vector<double> tips, needles;
                for (Needled& block : blocks) {
                    const MatrixX compliance = block.compliance(points);
                    tips.push_back(compliance(axis, axis));
                    needles.push_back(rigid_compliance(compliance, axis));
                }
                std::printf("  %c tip %.2f %.2f %.2f (%.2f) needle %.3f %.3f %.3f (%.3f)", "x z"[axis], 1e3 * tips[0],
                            1e3 * tips[1], 1e3 * tips[2], 1e3 * flat(axis, axis), 1e3 * needles[0], 1e3 * needles[1],
                            1e3 * needles[2], 1e3 * rigid_compliance(flat, axis));
                EXPECT_LE(spread_of(tips), wanted);
                EXPECT_LE(spread_of(needles), wanted);
            }
            std::printf("\n");
        }
    }
}

TEST(NearField, AddsWhatAMeshAloneAnswersByItsSize) {
    std::vector<double> alone;
    for (const std::array<int, 3>& cells : {std::array{6, 6, 5}, std::array{15, 15, 10}})
        alone.push_back(gel({0.1, 0.1, 0.05}, cells, 0.45, true).meshed({tip_at(entry)})(2, 2));
    std::printf("a tip on the meshes alone: %.2f and %.2f mm/N, of 52.8\n", 1e3 * alone[0], 1e3 * alone[1]);
    EXPECT_GE(spread_of(alone), 1.0) << "with nothing to correct, the other tests could not fail";
}

TEST(NearField, IsAsSoftOnAVertexAnEdgeAFaceOrInside) {
    constexpr double wanted = 0.01;    // hard case 22
    for (const double nu : {0.45, 0.49}) {
        for (const bool share_pressure : {false, true}) {
            Needled block = workload(nu, share_pressure);
            const double h = 0.1 / 11.0, v = 0.05 / 7.0;    // [m] edges of a cell
            const Vector3 vertex(0.5 * h, 0.5 * h, 0.0);
            for (const double layers : {0.0, 2.0, 4.0}) {
                std::vector<double> along, across;
                for (const Vector3& from : {Vector3(0.0, 0.0, 0.0), Vector3(0.5 * h, 0.0, 0.0),
                                            Vector3(2.0 / 3.0 * h, h / 3.0, 0.0), Vector3(0.75 * h, 0.5 * h, -0.25 * v)}) {
                    const MatrixX own = block.compliance({tip_at(vertex + from - Vector3(0.0, 0.0, layers * v))});
                    along.push_back(own(2, 2));
                    across.push_back(own(0, 0));
                }
                std::printf("nu %.2f, pressure by %s, %2.0f mm deep: %.3f %.3f %.3f %.3f mm/N along z\n", nu,
                            share_pressure ? "patch" : "tetrahedron", 1e3 * layers * v, 1e3 * along[0], 1e3 * along[1],
                            1e3 * along[2], 1e3 * along[3]);
                EXPECT_LE(spread_of(along), wanted);
                EXPECT_LE(spread_of(across), wanted);
            }
        }
    }
}

TEST(NearField, ChangesSmoothlyWhileTheNeedleMoves) {
    Needled block = workload(0.45, true);
    constexpr double step = 1e-5;    // [m]
    MatrixX last, last_change;
    double change = 0.0, bend = 0.0;    // [m/N] largest of a step, and by which two steps differ
    const auto look = [&](double length) {
        const Points points = needle(entry, slanting, length, piece);
        const MatrixX now = block.compliance({points[0]});
        if (last.size() > 0) change = std::max(change, (now - last).lpNorm<Eigen::Infinity>());
        if (last_change.size() > 0) bend = std::max(bend, (now - last - last_change).lpNorm<Eigen::Infinity>());
        if (last.size() > 0) last_change = now - last;
        last = now;
    };
    for (int i = 0; i < 900; ++i) look(1e-3 + i * step);
    const double own = last(2, 2);
    std::printf("a tip on its way through 9 mm: changes by at most %.1e of its compliance in 0.01 mm, bends by %.1e\n",
                change / own, bend / own);
    EXPECT_LE(change, 1e-5 * own) << "the mesh's own unevenness, half a percent over half an edge";
    EXPECT_LE(bend, 1e-6 * own) << "a jump";
}

TEST(NearField, LeavesNoNeedleWithNegativeCompliance) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> some(-1.0, 1.0);
    for (const bool share_pressure : {false, true}) {
        Needled block = workload(0.49, share_pressure);
        double least = 1.0, alone = 1.0, against_half_space = 1.0;
        int needles = 0;
        while (needles < 24) {
            const Vector3 at(0.04 * some(random), 0.04 * some(random), 0.0);
            Vector3 way = needles % 3 == 0 ? down : Vector3(some(random), some(random), -1.0).normalized();
            const double depth = 0.03 + 0.015 * some(random), each = needles % 2 == 0 ? 2e-3 : piece;
            Points points = needle(at, way, -depth / way.z(), each);
            if (needles % 3 == 2) {    // a bent track
                const Vector3 bend(0.1 * some(random), 0.1 * some(random), 0.0);
                Vector3 x = at;
                for (std::size_t p = 1; p < points.size(); ++p, way = (way + bend).normalized(), x += points[p - 1].span)
                    points[p] = shaft(x, x + points[p].span.norm() * way);
                points[0] = tip_at(points.back().material + points.back().span);
            }
            if (points[0].material.cwiseAbs().maxCoeff() > 0.049) continue;    // out of a side, or through the bottom
            ++needles;
            const MatrixX compliance = block.compliance(points);
            EXPECT_LE((compliance - compliance.transpose()).norm(), 1e-12 * compliance.norm());
            const double smallest = smallest_eigenvalue(compliance);
            least = std::min(least, smallest / (compliance.trace() / static_cast<double>(compliance.rows())));
            alone = std::min(alone, smallest_eigenvalue(block.near(points)) / smallest);
            against_half_space =
                std::min(against_half_space, smallest / smallest_eigenvalue(half_space(points, youngs_modulus, 0.49, radius)));
        }
        std::printf(
            "24 needles, pressure by %s: least eigenvalue %.3f of the mean one, %.3f of half_space's; of the near field alone "
            "%.3f\n",
            share_pressure ? "patch" : "tetrahedron", least, against_half_space, alone);
        EXPECT_GT(least, 0.0);
        EXPECT_GT(alone, 0.0) << "a mesh with inertia answers next to nothing in a short step";
        EXPECT_GT(against_half_space, 0.5) << "a mesh adds compliance to what only the needle feels, and takes little away";
    }
}

/// A mesh that reaches `size` in every direction, coarser outwards.
Mesh wide(double size, double finest) {
    std::vector<double> lines{0.0};
    for (double h = finest; lines.back() < size; h *= lines.size() > 2 ? 1.75 : 1.0) lines.push_back(lines.back() + h);
    const int n = static_cast<int>(lines.size()) - 1;
    TissueSetup tissue = block_of({2.0 * n, 2.0 * n, 1.0 * n}, youngs_modulus, 0.45);
    tissue.fixed = "bottom_and_sides";
    Mesh mesh = block_mesh(tissue, {2 * n, 2 * n, n});
    for (Vector3& x : mesh.nodes) {
        for (double& along : x) along = std::copysign(lines[std::lround(std::abs(along))], along);
    }
    return mesh;
}

TEST(NearField, ComesToHalfSpacesAnswerInAWideBlock) {
    // A rigid wall at a distance L takes O(1/L) away: what is left of two sizes when that is taken out is what counts.
    const TissueSetup tissue = block_of(Vector3::Constant(1.0), youngs_modulus, 0.45);
    const Mesh small = wide(0.2, 10e-3), large = wide(0.5, 10e-3);
    const double nearer = 1.0 / -small.nodes.front().z(), further = 1.0 / -large.nodes.front().z();    // [1/m]
    constexpr double wanted = 0.015;    // measured 0.01: G's own accuracy, and what the walls add beyond 1/L
    for (const double a : {0.3e-3, 20e-3}) {
        Needled in_small(tissue, small, a, true), in_large(tissue, large, a, true);
        for (const double length : {0.0, 10e-3, 30e-3}) {
            const Points points = needle(entry, down, length, piece);
            const MatrixX flat = half_space(points, youngs_modulus, 0.45, a);
            for (const int axis : {2, 0}) {
                const double first = rigid_compliance(in_small.compliance(points), axis),
                             second = rigid_compliance(in_large.compliance(points), axis);
                const double limit = second + (second - first) * further / (nearer - further);
                const double exact = rigid_compliance(flat, axis);
                std::printf("radius %4.1f mm, %2.0f mm deep along %c: %.3f and %.3f mm/N, wide %.3f, half_space %.3f\n", 1e3 * a,
                            1e3 * length, "x z"[axis], 1e3 * first, 1e3 * second, 1e3 * limit, 1e3 * exact);
                EXPECT_NEAR(limit / exact, 1.0, wanted);
            }
        }
    }
}

TEST(NearField, VanishesForANeedleAsThickAsTheTetrahedraAndIsNeverNegative) {
    const TissueSetup tissue = block_of({0.1, 0.1, 0.05}, youngs_modulus, 0.49);
    const Mesh mesh = block_mesh(tissue, {11, 11, 7});
    double last = 1.0;
    for (const double a : {0.3e-3, 3e-3, 10e-3, 20e-3, 40e-3}) {
        const Spread spread(mesh, a);
        NearField near_field(tissue, spread);
        near_field.place(0, tip_at(entry));
        const MatrixX own = near_field.compliance(1);
        const double share = own(2, 2) / half_space({tip_at(entry)}, youngs_modulus, 0.49, a)(2, 2);
        std::printf("radius %4.1f mm beside cells of 9 mm: %.3f of the tip's compliance\n", 1e3 * a, share);
        EXPECT_GE(smallest_eigenvalue(own), 0.0);
        EXPECT_LE(share, last);
        last = share;
    }
    constexpr double little = 0.1;
    EXPECT_LE(last, little);
}

TEST(NearField, EndsAtTheHeldBottom) {
    Needled block = workload(0.45, true);
    double last = 1.0;    // [m/N]
    for (const double depth : {20e-3, 30e-3, 40e-3, 50e-3}) {
        const double own = block.compliance({tip_at(entry + depth * down)})(2, 2),
                     meshed = block.meshed({tip_at(entry + depth * down)})(2, 2);
        std::printf("a tip %.0f mm deep, of 50: %.3f mm/N, of these %.3f of the mesh\n", 1e3 * depth, 1e3 * own, 1e3 * meshed);
        EXPECT_LT(own, last);
        EXPECT_GT(meshed, 0.0);
        last = own;
    }
}

TEST(NearField, WorksOutOnlyWhatHasChanged) {
    Needled block = workload(0.45, true), fresh = workload(0.45, true);
    const Points before = needle(entry, slanting, 22e-3, piece), after = needle(entry, slanting, 24e-3, piece);
    const MatrixX first = block.near(before);
    EXPECT_EQ(block.near(before), first) << "asked for the same points twice";
    EXPECT_EQ(block.near({before.begin(), before.begin() + 2}), first.topLeftCorner(6, 6));
    EXPECT_EQ(block.near(after), fresh.near(after)) << "a needle that moved on, and one that was there at once";
}

TEST(NearField, AllocatesNothingOnceMade) {
    Needled block = workload(0.45, true);
    const Points before = needle(entry, slanting, 22e-3, piece), after = needle(entry, slanting, 24e-3, piece);
    const std::size_t allocations = contract::allocations();
    for (const Points* points : {&before, &after}) {
        for (std::size_t i = 0; i < points->size(); ++i) {
            (void)block.spread().of((*points)[i]);
            block.near_field().place(static_cast<int>(i), (*points)[i]);
        }
        (void)block.near_field().compliance(static_cast<int>(points->size()));
    }
    EXPECT_EQ(contract::allocations(), allocations);
}

TEST(NearField, FeelsALayerComeWithoutAJump) {
    TissueSetup tissue = block_of({0.1, 0.1, 0.05}, youngs_modulus, 0.49);
    tissue.layers.insert(tissue.layers.begin(), tissue.layers.front());
    tissue.layers[0].thickness = 10e-3;
    tissue.layers[0].youngs_modulus = 100e3;
    tissue.layers[0].poisson_ratio = 0.45;
    tissue.layers[1].thickness = 40e-3;
    Needled block(tissue, block_mesh(tissue, {11, 11, 7}), radius, true);
    const auto tip = [&](double depth) { return block.compliance({tip_at(entry + depth * down)})(2, 2); };
    const double above = tip(5e-3), below = tip(15e-3);
    constexpr double step = 2e-5, width = 8.0 * radius;    // [m]
    double change = 0.0;
    for (double depth = 8e-3; depth < 12e-3; depth += step) change = std::max(change, std::abs(tip(depth + step) - tip(depth)));
    std::printf("a tip from 100 kPa into 25 kPa: from %.2f to %.2f mm/N, by at most %.3f in 0.02 mm\n", 1e3 * above, 1e3 * below,
                1e3 * change);
    EXPECT_GT(below, 3.0 * above) << "the punch of each layer's modulus";
    constexpr double steepest = 3.0;    // of a smooth step between logarithms, beside an even slope
    EXPECT_LE(change, steepest * (below - above) * step / width);
}

TEST(NearField, ShowsTheDentInThePicture) {
    Needled block = workload(0.45, true);
    const Points points = needle(entry, slanting, 12e-3, piece);
    const auto count = static_cast<int>(points.size());
    VectorX forces = VectorX::Zero(3 * count);
    forces.head<3>() = Vector3(0.01, 0.0, -0.05);
    forces.tail<3>() = Vector3(0.02, 0.03, -0.01);
    const VectorX moved = block.compliance(points) * forces;
    (void)block.newton().try_step({forces.data(), forces.size()});
    // Mean over the last piece of shaft of what the picture shows there: the mesh, and the dent.
    const Locator locator(block.mesh());
    Vector3 shown = Vector3::Zero();
    const Footprint footprint(points.back());
    for (const Vector3& x : footprint.samples()) {
        const MeshPlace place = locator.find(x);
        Vector3 mesh = Vector3::Zero();
        for (int c = 0; c < 4; ++c)
            mesh += place.weights[c] * block.newton().displacement(block.mesh().tetrahedra[place.tetrahedron][c]);
        shown += (mesh + block.near_field().displacement(x, {forces.data(), forces.size()})) / Footprint::shaft_samples;
    }
    const Vector3 felt = moved.tail<3>();
    std::printf("a piece of shaft moves by (%.4f, %.4f, %.4f) mm and is shown moved by (%.4f, %.4f, %.4f)\n", 1e3 * felt.x(),
                1e3 * felt.y(), 1e3 * felt.z(), 1e3 * shown.x(), 1e3 * shown.y(), 1e3 * shown.z());
    constexpr double alike = 0.1;    // the picture reads the mesh at a point, the contact by its balls
    EXPECT_LE((shown - felt).norm(), alike * felt.norm());
}

}    // namespace
}    // namespace stylet::corotational_fem
