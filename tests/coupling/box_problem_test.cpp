#include "core/coupling/box_problem.h"

#include <stylet/contract/allocations.h>

#include <gtest/gtest.h>

#include "random_problems.h"

#include <cmath>
#include <optional>

namespace stylet::core {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nobody_reads = std::numeric_limits<double>::quiet_NaN();
constexpr int most_rows = 100;

// Forces and motions are of the order 1 to 10: nine digits leave room for the condition of a few thousand of these problems.
constexpr double agreement = 1e-9;
// The same set of rows gives the same linear system; only the order of earlier roundings may differ.
constexpr double rounding = 1e-12;

struct Problem {
    MatrixX a;
    VectorX b, lower, upper;
    int bilateral, negatives;

    [[nodiscard]] int rows() const { return static_cast<int>(b.size()); }
    [[nodiscard]] int boxed() const { return rows() - bilateral; }
};

struct Answer {
    BoxProblem::Outcome outcome;
    VectorX lambda;
};

Answer solve(BoxProblem& box, const Problem& problem) {
    MatrixX a = lower_triangle(problem.a);
    VectorX b = problem.b;
    Answer answer{.outcome = {}, .lambda = VectorX::Constant(problem.rows(), nobody_reads)};
    answer.outcome = box.solve(a, b, problem.lower, problem.upper, problem.bilateral, answer.lambda);
    return answer;
}

// The bounds of one box row: the kinds that contacts have.
void draw_bounds(Draw& draw, double& lower, double& upper) {
    const double limit = draw.between(0.0, 1.0);
    switch (draw.below(6)) {
        case 0:
            lower = -limit, upper = limit;
            break;    // friction
        case 1:
            lower = 0.0, upper = limit;
            break;    // a tip
        case 2:
            lower = 0.0, upper = infinity;
            break;    // a tip that nothing limits
        case 3:
            lower = -infinity, upper = infinity;
            break;    // stuck for good
        case 4:
            lower = -infinity, upper = limit;
            break;
        default:
            lower = upper = draw.below(2) * limit;    // without friction, or held at a force
    }
}

Problem draw_problem(Draw& draw, int bilateral, int negatives, const MatrixX& schur) {
    const int n = bilateral + static_cast<int>(schur.rows());
    Problem problem{.a = with_schur_complement(draw, bilateral, negatives, schur),
                    .b = draw.matrix(n, 1),
                    .lower = VectorX::Constant(n, nobody_reads),
                    .upper = VectorX::Constant(n, nobody_reads),
                    .bilateral = bilateral,
                    .negatives = negatives};
    for (int i = bilateral; i < n; ++i) draw_bounds(draw, problem.lower[i], problem.upper[i]);
    return problem;
}

Problem draw_problem(Draw& draw, int most_bilateral, int boxed) {
    const int bilateral = draw.below(most_bilateral + 1);
    const int negatives = draw.below(bilateral + 1);
    return draw_problem(draw, bilateral, negatives, draw.symmetric(boxed, 0));
}

// How far λ is from the conditions that define the answer.
double violation(const Problem& problem, const VectorX& lambda) {
    const VectorX v = problem.a * lambda + problem.b;
    double worst = problem.bilateral > 0 ? v.head(problem.bilateral).lpNorm<Eigen::Infinity>() : 0.0;
    for (int i = problem.bilateral; i < problem.rows(); ++i) {
        const double low = problem.lower[i], high = problem.upper[i];
        worst = std::max({worst, low - lambda[i], lambda[i] - high});
        if (low == high) continue;
        if (lambda[i] > low) worst = std::max(worst, std::min(v[i], lambda[i] - low));       // v > 0 only at lower
        if (lambda[i] < high) worst = std::max(worst, std::min(-v[i], high - lambda[i]));    // v < 0 only at upper
    }
    return lambda.allFinite() ? worst : infinity;
}

// Tries every combination of rows at a bound and rows that are free, by Eigen's full pivoting.
std::optional<VectorX> brute_force(const Problem& problem) {
    const int boxed = problem.boxed();
    const int sets = static_cast<int>(std::pow(3, boxed));
    for (int set = 0; set < sets; ++set) {
        MatrixX a = problem.a;
        VectorX b = -problem.b;
        bool possible = true;
        for (int i = 0, digits = set; i < boxed; ++i, digits /= 3) {
            const int row = problem.bilateral + i;
            if (digits % 3 == 0) continue;
            const double bound = digits % 3 == 1 ? problem.lower[row] : problem.upper[row];
            possible = possible && std::isfinite(bound);
            a.row(row).setZero();
            a(row, row) = 1.0;
            b[row] = bound;
        }
        if (!possible) continue;
        const VectorX lambda = a.fullPivLu().solve(b);
        if (violation(problem, lambda) <= agreement) return lambda;
    }
    return std::nullopt;
}

// Projected Gauss–Seidel on the Schur complement, run until nothing moves; Eigen gives the complement and the bilateral forces.
VectorX gauss_seidel(const Problem& problem) {
    const int m = problem.bilateral, boxed = problem.boxed();
    const Eigen::PartialPivLU<MatrixX> block(problem.a.topLeftCorner(m, m));
    MatrixX schur = problem.a.bottomRightCorner(boxed, boxed);
    VectorX right = problem.b.tail(boxed);
    if (m > 0) {
        schur -= problem.a.bottomLeftCorner(boxed, m) * block.solve(problem.a.topRightCorner(m, boxed));
        right -= problem.a.bottomLeftCorner(boxed, m) * block.solve(problem.b.head(m));
    }
    VectorX lambda = VectorX::Zero(problem.rows());
    auto box = lambda.tail(boxed);
    constexpr int sweeps = 1000;    // condition 4: each sweep gains more than a tenth of a digit
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        for (int i = 0; i < boxed; ++i) {
            const double wanted = box[i] - (schur.row(i).dot(box) + right[i]) / schur(i, i);
            box[i] = std::clamp(wanted, problem.lower[m + i], problem.upper[m + i]);
        }
    }
    if (m > 0) lambda.head(m) = -block.solve(problem.b.head(m) + problem.a.topRightCorner(m, boxed) * box);
    return lambda;
}

TEST(BoxProblem, AgreesWithBruteForceOverEveryActiveSet) {
    Draw draw(11);
    BoxProblem box(most_rows);
    for (int trial = 0; trial < 200; ++trial) {
        const Problem problem = draw_problem(draw, 6, trial % 6 + 1);
        const Answer answer = solve(box, problem);
        ASSERT_TRUE(answer.outcome.solved) << "trial " << trial;
        const std::optional<VectorX> expected = brute_force(problem);
        ASSERT_TRUE(expected) << "trial " << trial;
        EXPECT_LE((answer.lambda - *expected).lpNorm<Eigen::Infinity>(), agreement) << "trial " << trial;
    }
}

TEST(BoxProblem, AgreesWithGaussSeidelUpToFortyBoxRows) {
    Draw draw(12);
    BoxProblem box(most_rows);
    for (int trial = 0; trial < 200; ++trial) {
        const Problem problem = draw_problem(draw, 60, trial % 40 + 1);
        const Answer answer = solve(box, problem);
        ASSERT_TRUE(answer.outcome.solved) << "trial " << trial;
        EXPECT_LE((answer.lambda - gauss_seidel(problem)).lpNorm<Eigen::Infinity>(), agreement) << "trial " << trial;
    }
}

TEST(BoxProblem, MeetsItsConditionsAndCountsTheNegatives) {
    Draw draw(13);
    BoxProblem box(most_rows);
    for (int trial = 0; trial < 300; ++trial) {
        const Problem problem = draw_problem(draw, 60, trial % 40 + 1);
        const Answer answer = solve(box, problem);
        ASSERT_TRUE(answer.outcome.solved) << "trial " << trial;
        EXPECT_LE(violation(problem, answer.lambda), agreement) << "trial " << trial;
        EXPECT_EQ(answer.outcome.negatives, negative_eigenvalues(problem.a.topLeftCorner(problem.bilateral, problem.bilateral)));
        EXPECT_EQ(answer.outcome.negatives, problem.negatives);
    }
}

// A stiff needle moves all its contacts together: rows almost alike, condition 1e6, where Gauss–Seidel would take for ever.
TEST(BoxProblem, SolvesRowsThatAreAlmostAlike) {
    Draw draw(14);
    BoxProblem box(most_rows);
    for (int trial = 0; trial < 100; ++trial) {
        const int boxed = 40;
        const MatrixX alike = MatrixX::Ones(boxed, boxed) + 4e-5 * draw.symmetric(boxed, 0);
        const Problem problem = draw_problem(draw, 10, 3, alike);
        const Answer answer = solve(box, problem);
        ASSERT_TRUE(answer.outcome.solved) << "trial " << trial;
        // Forces reach 1e5 where all rows stick: nine digits of those.
        EXPECT_LE(violation(problem, answer.lambda), agreement * (1.0 + answer.lambda.lpNorm<Eigen::Infinity>()))
            << "trial " << trial;
    }
}

// Of these, one in two thousand makes principal pivoting on all wrong rows at once go in circles for ever.
TEST(BoxProblem, EndsWherePivotingOnAllWrongRowsWouldCycle) {
    Draw draw(23);
    for (int trial = 0; trial < 20000; ++trial) {
        const int n = 4;
        const MatrixX root = draw.matrix(n, n);
        const MatrixX nearly_singular = root * root.transpose() + 1e-3 * MatrixX::Identity(n, n);
        Problem problem = draw_problem(draw, 0, 0, nearly_singular);
        problem.lower.setZero();
        problem.upper.setConstant(infinity);
        BoxProblem box(n);
        const Answer answer = solve(box, problem);
        ASSERT_TRUE(answer.outcome.solved) << "trial " << trial;
        // Forces reach a thousand over the 1e-3 of the matrix.
        ASSERT_LE(violation(problem, answer.lambda), agreement * (1.0 + answer.lambda.lpNorm<1>())) << "trial " << trial;
    }
}

TEST(BoxProblem, GivesTheSameAnswerFromAnyStart) {
    Draw draw(15);
    BoxProblem warm(most_rows);
    for (int trial = 0; trial < 100; ++trial) {
        const Problem problem = draw_problem(draw, 30, 20);
        BoxProblem fresh(most_rows);
        const Answer expected = solve(fresh, problem);
        ASSERT_TRUE(expected.outcome.solved);
        const double tolerance = rounding * expected.lambda.lpNorm<1>();
        for (int start = 0; start < 5; ++start) {
            (void)solve(warm, draw_problem(draw, 30, 20));    // leaves its rows in places that are wrong here
            const Answer answer = solve(warm, problem);
            ASSERT_TRUE(answer.outcome.solved);
            EXPECT_LE((answer.lambda - expected.lambda).lpNorm<Eigen::Infinity>(), tolerance);
        }
    }
}

TEST(BoxProblem, FindsItsLastSetAgainAtOnce) {
    Draw draw(16);
    BoxProblem box(most_rows);
    for (int trial = 0; trial < 50; ++trial) {
        const Problem problem = draw_problem(draw, 30, 30);
        (void)solve(box, problem);
        EXPECT_EQ(solve(box, problem).outcome.sets, 1);
    }
}

TEST(BoxProblem, HoldsARowOfEqualBoundsAtExactlyThatForce) {
    Draw draw(17);
    BoxProblem box(most_rows);
    Problem problem = draw_problem(draw, 6, 2, draw.symmetric(5, 0));
    problem.lower.tail(5).setConstant(0.25);
    problem.upper.tail(5).setConstant(0.25);
    const Answer answer = solve(box, problem);
    ASSERT_TRUE(answer.outcome.solved);
    EXPECT_EQ(VectorX(answer.lambda.tail(5)), VectorX::Constant(5, 0.25));
    EXPECT_LE(violation(problem, answer.lambda), agreement);
}

TEST(BoxProblem, WithoutBoundsIsALinearSystem) {
    Draw draw(18);
    BoxProblem box(most_rows);
    Problem problem = draw_problem(draw, 6, 2, draw.symmetric(5, 0));
    problem.lower.tail(5).setConstant(-infinity);
    problem.upper.tail(5).setConstant(infinity);
    const Answer answer = solve(box, problem);
    ASSERT_TRUE(answer.outcome.solved);
    EXPECT_LE((answer.lambda + problem.a.fullPivLu().solve(problem.b)).lpNorm<Eigen::Infinity>(), agreement);
}

TEST(BoxProblem, RefusesASingularBilateralBlock) {
    Draw draw(19);
    BoxProblem box(most_rows);
    Problem problem = draw_problem(draw, 4, 1, draw.symmetric(3, 0));
    problem.a.topRows(2).setOnes();
    problem.a.leftCols(2).setOnes();
    EXPECT_FALSE(solve(box, problem).outcome.solved);
}

TEST(BoxProblem, SaysThatBoxRowsAreNotConvex) {
    Draw draw(20);
    BoxProblem box(most_rows);
    Problem problem = draw_problem(draw, 4, 1, draw.symmetric(3, 1));
    problem.lower.tail(3).setConstant(-infinity);
    problem.upper.tail(3).setConstant(infinity);
    const auto answer = solve(box, problem);
    EXPECT_TRUE(answer.outcome.solved);
    EXPECT_FALSE(answer.outcome.convex);
    EXPECT_EQ(answer.outcome.negatives, 1 + 1);    // the bilateral rows' and the box's
}

TEST(BoxProblem, RefusesWhatIsNotFinite) {
    Draw draw(21);
    BoxProblem box(most_rows);
    for (int trial = 0; trial < 50; ++trial) {
        const Problem problem = draw_problem(draw, 6, 4);
        Problem nowhere = problem;
        nowhere.b[trial % problem.rows()] = nobody_reads;
        EXPECT_FALSE(solve(box, nowhere).outcome.solved) << "trial " << trial;
        if (problem.bilateral == 0) continue;
        Problem unmoved = problem;
        unmoved.a(trial % problem.bilateral, 0) = nobody_reads;
        EXPECT_FALSE(solve(box, unmoved).outcome.solved) << "trial " << trial;
    }
}

TEST(BoxProblem, AllocatesNothing) {
    Draw draw(22);
    BoxProblem box(most_rows);
    const Problem problem = draw_problem(draw, 40, 7, draw.symmetric(40, 0));
    MatrixX a = lower_triangle(problem.a);
    VectorX b = problem.b;
    VectorX lambda(problem.rows());
    const std::size_t before = contract::allocations();
    const BoxProblem::Outcome outcome = box.solve(a, b, problem.lower, problem.upper, problem.bilateral, lambda);
    EXPECT_EQ(contract::allocations(), before);
    EXPECT_TRUE(outcome.solved);
}

}    // namespace
}    // namespace stylet::core
