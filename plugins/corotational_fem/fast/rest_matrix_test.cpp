#include "fast/rest_matrix.h"

#include "fast/rest_for_tests.h"
#include "mesh/mass.h"

#include <gtest/gtest.h>

namespace stylet::corotational_fem {
namespace {

using namespace testing;

constexpr double rounding = 1e-12;    // of sums of some tens of numbers, relative to the greatest of them

const std::vector<Material> two_layers{elastic(25e3, 0.49, 1000.0), elastic(60e3, 0.3, 1200.0)};

// K as the double-precision solid has it at rest, written by somebody else.
MatrixX stiffness_of_solid(const Mesh& mesh, bool share_pressure) {
    Solid solid(mesh, two_layers, share_pressure);
    Tangent tangent(mesh, share_pressure);
    solid.stiffen(VectorX::Zero(3 * mesh.node_count()), Twists::exact, tangent);
    return MatrixX(Eigen::SparseMatrix<double>(tangent.matrix().selfadjointView<Eigen::Lower>()));
}

double greatest_difference(const MatrixX& a, const MatrixX& b) {
    return (a - b).lpNorm<Eigen::Infinity>() / b.lpNorm<Eigen::Infinity>();
}

TEST(RestMatrix, IsTheSolidsTangentAtRest) {
    const Mesh mesh = uneven_block({4, 3, 3});
    for (const bool share_pressure : {false, true}) {
        Motion motion;
        motion.share_pressure = share_pressure;
        const MatrixX k = MatrixX(sparse(rest_matrix(mesh, two_layers, motion)));
        EXPECT_LT(greatest_difference(k, stiffness_of_solid(mesh, share_pressure)), rounding) << share_pressure;
    }
}

TEST(RestMatrix, TakesMassAndDampingByTheFormula) {
    const Mesh mesh = uneven_block({4, 3, 3});
    Motion motion = backward_euler(2e-3);
    motion.damping_time = 5e-3;
    const MatrixX a = MatrixX(sparse(rest_matrix(mesh, two_layers, motion)));
    const MatrixX k = MatrixX(sparse(rest_matrix(mesh, two_layers, quasi_static())));
    const VectorX mass = lumped_mass(mesh, two_layers);
    const Tangent order(mesh, false);
    MatrixX expected = 3.5 * k;    // 1 + 5 ms/2 ms
    for (int i = 0; i < order.free_nodes(); ++i) {
        expected.diagonal().segment<3>(3 * i).array() += mass[order.nodes()[i]] / 4e-6;    // dt²
    }
    EXPECT_LT(greatest_difference(a, expected), rounding);
}

TEST(RestMatrix, LeavesOutFixedNodes) {
    const Mesh mesh = uneven_block({3, 3, 2});
    const BlockMatrix a = rest_matrix(mesh, two_layers, quasi_static());
    EXPECT_EQ(a.rows(), 16 * 2);
    for (int node = 0; node < mesh.node_count(); ++node) {
        if (mesh.fixed[node]) {
            EXPECT_EQ(a.row[node], -1);
        } else {
            EXPECT_EQ(a.mesh_node[a.row[node]], node);
        }
    }
}

}    // namespace
}    // namespace stylet::corotational_fem
