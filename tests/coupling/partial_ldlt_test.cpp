#include "core/coupling/partial_ldlt.h"

#include <stylet/contract/allocations.h>

#include <gtest/gtest.h>

#include "random_problems.h"

namespace stylet::core {
namespace {

// Condition numbers are at most a few hundred here, so a backward stable elimination loses three digits of sixteen.
constexpr double rounding = 1e-12;
constexpr int trials = 200;
constexpr int most_rows = 60;

struct Sizes {
    int eliminated, left, negatives;
};

Sizes draw_sizes(Draw& draw) {
    Sizes sizes{.eliminated = 1 + draw.below(30), .left = 0, .negatives = 0};
    sizes.left = 1 + draw.below(20);
    sizes.negatives = draw.below(sizes.eliminated + 1);
    return sizes;
}

TEST(PartialLdlt, CountsTheNegativeEigenvaluesThatEigenFinds) {
    Draw draw(1);
    PartialLdlt ldlt(most_rows);
    for (int trial = 0; trial < trials; ++trial) {
        const Sizes sizes = draw_sizes(draw);
        const MatrixX a = draw.symmetric(sizes.eliminated, sizes.negatives);
        ASSERT_EQ(negative_eigenvalues(a), sizes.negatives);
        MatrixX work = lower_triangle(a);
        const PartialLdlt::Inertia inertia = ldlt.eliminate(work, sizes.eliminated);
        EXPECT_FALSE(inertia.singular);
        EXPECT_EQ(inertia.negatives, sizes.negatives);
    }
}

TEST(PartialLdlt, LeavesTheSchurComplement) {
    Draw draw(2);
    PartialLdlt ldlt(most_rows);
    for (int trial = 0; trial < trials; ++trial) {
        const Sizes sizes = draw_sizes(draw);
        const MatrixX schur = draw.symmetric(sizes.left, draw.below(sizes.left + 1));
        MatrixX work = lower_triangle(with_schur_complement(draw, sizes.eliminated, sizes.negatives, schur));
        ldlt.eliminate(work, sizes.eliminated);
        const MatrixX found = work.bottomRightCorner(sizes.left, sizes.left).selfadjointView<Eigen::Lower>();
        EXPECT_LE((found - schur).lpNorm<1>(), rounding * (1 + sizes.left) * (1 + sizes.left));
    }
}

TEST(PartialLdlt, SolvesWhatItEliminatedForAnyOtherUnknowns) {
    Draw draw(3);
    PartialLdlt ldlt(most_rows);
    for (int trial = 0; trial < trials; ++trial) {
        const Sizes sizes = draw_sizes(draw);
        const int n = sizes.eliminated + sizes.left;
        const MatrixX a = with_schur_complement(draw, sizes.eliminated, sizes.negatives, draw.symmetric(sizes.left, 0));
        const VectorX b = draw.matrix(n, 1);
        MatrixX work = lower_triangle(a);
        VectorX reduced = b;
        VectorX x(n);
        x.tail(sizes.left) = draw.matrix(sizes.left, 1);
        ldlt.eliminate(work, sizes.eliminated);
        ldlt.reduce(work, reduced);
        ldlt.substitute(work, reduced, x);
        const VectorX v = a * x + b;
        EXPECT_LE(v.head(sizes.eliminated).lpNorm<Eigen::Infinity>(), rounding * (1.0 + x.cwiseAbs().sum()));
        // The reduced right-hand side and the Schur complement give the same other rows.
        const VectorX others =
            work.bottomRightCorner(sizes.left, sizes.left).selfadjointView<Eigen::Lower>() * x.tail(sizes.left);
        EXPECT_LE((others + reduced.tail(sizes.left) - v.tail(sizes.left)).lpNorm<Eigen::Infinity>(),
                  rounding * n * (1.0 + x.cwiseAbs().sum()));
    }
}

TEST(PartialLdlt, TakesAPairWhereTheDiagonalIsZero) {
    MatrixX a(3, 3);
    a << 0.0, 1.0, 2.0,    //
        1.0, 0.0, 3.0,     //
        2.0, 3.0, 20.0;
    MatrixX work = lower_triangle(a);
    PartialLdlt ldlt(3);
    const PartialLdlt::Inertia inertia = ldlt.eliminate(work, 2);
    EXPECT_FALSE(inertia.singular);
    EXPECT_EQ(inertia.negatives, 1);
    EXPECT_DOUBLE_EQ(work(2, 2), 20.0 - 2.0 * 2.0 * 3.0);
}

TEST(PartialLdlt, TellsASingularBlock) {
    PartialLdlt ldlt(3);
    for (const int rows : {1, 2, 3}) {
        MatrixX zeros = MatrixX::Zero(3, 3);
        EXPECT_TRUE(ldlt.eliminate(zeros, rows).singular);
        if (rows == 1) continue;
        MatrixX alike = MatrixX::Ones(3, 3);
        EXPECT_TRUE(ldlt.eliminate(alike, rows).singular);
    }
}

TEST(PartialLdlt, AllocatesNothing) {
    Draw draw(4);
    PartialLdlt ldlt(most_rows);
    MatrixX work = lower_triangle(draw.symmetric(40, 11));
    VectorX b = draw.matrix(40, 1);
    VectorX x = VectorX::Zero(40);
    const std::size_t before = contract::allocations();
    ldlt.eliminate(work, 30);
    ldlt.reduce(work, b);
    ldlt.substitute(work, b, x);
    EXPECT_EQ(contract::allocations(), before);
}

}    // namespace
}    // namespace stylet::core
