#include "fast/factor.h"

#include "fast/rest_for_tests.h"

#include <stylet/error.h>

#include <gtest/gtest.h>

#include <cstdio>

namespace stylet::corotational_fem {
namespace {

using namespace testing;

// Double precision's 10⁻¹⁶ times the matrices' condition, of 10⁵ or so. Layers that differ by 10⁶ add that to it.
constexpr double accuracy = 1e-10;
constexpr double accuracy_of_contrast = 1e-7;

// The worst of all instruction sets that this machine has.
double error_against_eigen(const BlockMatrix& a) {
    const Dissection d = dissect(a);
    const VectorX b = noise(3 * a.rows(), 1.0, 1), expected = solution(a, b);
    double worst = 0.0;
    for (const InstructionSet set : {InstructionSet::sse2, InstructionSet::avx2, InstructionSet::avx512}) {
        if (!supported(set)) continue;
        Factor factor(d, set);
        factor.refactor(a, one_thread());
        VectorX x = in_places(d, b);
        factor.solve(x);
        const double error = (in_rows(d, x) - expected).norm() / expected.norm();
        std::printf("%4d rows, %-7s: %.1e\n", a.rows(), name(set), error);
        worst = std::max(worst, error);
    }
    return worst;
}

TEST(Factor, SolvesAsEigenDoes) {
    const std::vector<Material> gel = alike(elastic(25e3, 0.49, 1000.0));
    const Mesh mesh = uneven_block({8, 7, 6});
    for (const Motion& motion : {quasi_static(), backward_euler(1e-3), with_shared_pressure(backward_euler(1e-2))}) {
        EXPECT_LT(error_against_eigen(rest_matrix(mesh, gel, motion)), accuracy);
    }
    EXPECT_LT(error_against_eigen(rest_matrix(uneven_block({1, 1, 1}), gel, quasi_static())), accuracy);
}

TEST(Factor, SolvesLayersAMillionTimesAsStiff) {
    const Mesh mesh = uneven_block({8, 7, 6});
    const Material soft = elastic(1e3, 0.49, 1000.0), stiff = elastic(1e9, 0.3, 1000.0);
    EXPECT_LT(error_against_eigen(rest_matrix(mesh, std::vector{soft, stiff}, quasi_static())), accuracy_of_contrast);
    EXPECT_LT(error_against_eigen(rest_matrix(mesh, std::vector{stiff, soft}, quasi_static())), accuracy_of_contrast);
}

TEST(Factor, RefusesWhatTheMachineHasNoRoomFor) {
    Dissection d;
    d.supernodes = {{.first = 0, .size = 1'000'000, .rows_begin = 0, .rows = 0}};
    try {
        const Factor factor(d);
        FAIL() << "72 TB are room for nothing";
    } catch (const Error& error) {
        const std::string found = error.what();
        EXPECT_EQ(found.rfind("found a mesh whose factor takes 72000.00 GB, wanted one of at most ", 0), 0u) << found;
    }
}

TEST(Factor, TakesNewValues) {
    const Mesh mesh = uneven_block({6, 5, 4});
    const BlockMatrix once = rest_matrix(mesh, alike(elastic(25e3, 0.49, 1000.0)), quasi_static());
    const BlockMatrix then = rest_matrix(mesh, alike(elastic(10e3, 0.3, 1000.0)), backward_euler(1e-3));
    const Dissection d = dissect(once);
    Factor factor(d), fresh(d);
    factor.refactor(once, one_thread());
    factor.refactor(then, one_thread());
    fresh.refactor(then, one_thread());
    VectorX x = noise(3 * d.places(), 1.0, 1), y = x;
    factor.solve(x);
    fresh.solve(y);
    EXPECT_EQ(x, y);
}

TEST(Factor, IsTheSameForAnyNumberOfThreads) {
    const BlockMatrix a = rest_matrix(uneven_block({8, 7, 6}), alike(elastic(25e3, 0.49, 1000.0)), quasi_static());
    const Dissection d = dissect(a);
    Factor one(d), three(d);
    Threads threads(3);
    one.refactor(a, one_thread());
    three.refactor(a, threads);
    VectorX x = noise(3 * d.places(), 1.0, 1), y = x;
    one.solve(x);
    three.solve(y);
    EXPECT_EQ(x, y);
}

std::string refusal(const BlockMatrix& a) {
    const Dissection d = dissect(a);
    Factor factor(d);
    try {
        factor.refactor(a, one_thread());
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(Factor, RefusesTissueThatNothingHolds) {
    const std::vector<Material> gel = alike(elastic(25e3, 0.49, 1000.0));
    for (const Cells& cells : {Cells{1, 1, 1}, Cells{4, 4, 4}, Cells{10, 9, 8}}) {
        Mesh mesh = uneven_block(cells);
        mesh.fixed.assign(mesh.fixed.size(), 0);
        EXPECT_EQ(refusal(rest_matrix(mesh, gel, quasi_static())).substr(0, 9), "singular:");
        mesh.fixed[0] = 1;    // may still turn about it
        EXPECT_EQ(refusal(rest_matrix(mesh, gel, quasi_static())).substr(0, 9), "singular:");
    }
}

TEST(Factor, RefusesWhatIsNotPositiveDefinite) {
    const Mesh mesh = uneven_block({4, 4, 4});
    const std::vector<Material> negative = alike({.shear_modulus = -1e3, .lame = 1e3, .density = 1000.0});
    EXPECT_EQ(refusal(rest_matrix(mesh, negative, quasi_static())).substr(0, 9), "singular:");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(refusal(rest_matrix(mesh, alike({nan, 1e3, 1e3}), quasi_static())).substr(0, 9), "singular:");
}

}    // namespace
}    // namespace stylet::corotational_fem
