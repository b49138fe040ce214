#include "core/export/tissue_grid.h"

#include <gtest/gtest.h>

#include <limits>

namespace stylet::core {
namespace {

constexpr double rounding = 1e-12;    // of sums of a dozen lengths

std::vector<double> pieces_of(const std::vector<double>& ends) {
    std::vector<double> pieces;
    for (std::size_t i = 0; i < ends.size(); ++i) pieces.push_back(ends[i] - (i == 0 ? 0.0 : ends[i - 1]));
    return pieces;
}

TEST(GradedPlaces, BeginFineAndEachPieceIsLongerByTheSameFactor) {
    const std::vector<double> pieces = pieces_of(graded(0.2, 12, 0.3e-3));
    ASSERT_EQ(pieces.size(), 12u);
    EXPECT_NEAR(pieces.front(), 0.3e-3, rounding);
    const double growth = pieces[1] / pieces[0];
    EXPECT_GT(growth, 1.0);
    for (std::size_t i = 2; i < pieces.size(); ++i) EXPECT_NEAR(pieces[i] / pieces[i - 1], growth, 1e-9);
}

TEST(GradedPlaces, EndExactlyWhereTheyShall) {
    for (const double length : {1e-6, 0.1, 0.15, 7.0}) EXPECT_EQ(graded(length, 12, 0.3e-3).back(), length);
}

TEST(GradedPlaces, AreEvenWhereEvenPiecesAreFineEnough) {
    for (const double first : {0.01, 0.1, std::numeric_limits<double>::infinity()}) {
        for (const double piece : pieces_of(graded(0.12, 12, first))) EXPECT_NEAR(piece, 0.01, rounding);
    }
}

TEST(GradedPlaces, OfNoLengthAreNone) {
    EXPECT_TRUE(graded(0.0, 12, 0.3e-3).empty());
    EXPECT_TRUE(graded(-1.0, 12, 0.3e-3).empty());
}

}    // namespace
}    // namespace stylet::core
