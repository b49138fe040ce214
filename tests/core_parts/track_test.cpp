#include "core/contacts/track.h"

#include <stylet/contract/allocations.h>

#include <gtest/gtest.h>

namespace stylet::core {
namespace {

constexpr double spacing = 0.005;     // [m]
constexpr double rounding = 1e-15;    // [m] of lengths of a few centimetres
constexpr int most_nodes = 20;

const Vector3 entry(0.01, 0.0, 0.0);
const Vector3 down(0.0, 0.0, -1.0);
const Vector3 aside = Vector3(0.6, 0.0, -0.8);

Track begun() {
    Track track(spacing, most_nodes);
    track.begin(entry, down);
    return track;
}

TEST(Track, IsNoneBeforeItBegins) {
    EXPECT_FALSE(Track(spacing, most_nodes).begun());
    EXPECT_TRUE(begun().begun());
}

TEST(Track, CutsOnlyWhatTheTipHasNotPassedBefore) {
    Track track = begun();
    EXPECT_NEAR(track.reach(0.003, down), 0.003, rounding);
    EXPECT_EQ(track.reach(0.001, down), 0.0);
    EXPECT_EQ(track.reach(0.003, down), 0.0);
    EXPECT_NEAR(track.reach(0.012, down), 0.009, rounding);
    EXPECT_NEAR(track.cut(), 0.012, rounding);
}

TEST(Track, HasANodeForEachSpacing) {
    Track track = begun();
    (void)track.reach(0.9 * spacing, down);
    EXPECT_EQ(track.nodes(), 1);
    (void)track.reach(3.1 * spacing, down);
    EXPECT_EQ(track.nodes(), 4);
    for (int i = 0; i < track.nodes(); ++i) {
        EXPECT_LE((track.node(i) - (entry + i * spacing * down)).norm(), rounding);
        EXPECT_NEAR(track.way_of(i), i * spacing, rounding);
    }
}

TEST(Track, TurnsWithTheNeedlePieceByPiece) {
    Track track = begun();
    (void)track.reach(0.5 * spacing, aside);    // within the first piece, which keeps the direction it was begun in
    EXPECT_LE((track.material(0.5 * spacing) - (entry + 0.5 * spacing * down)).norm(), rounding);
    (void)track.reach(1.2 * spacing, aside);
    EXPECT_LE((track.material(spacing) - (entry + spacing * down)).norm(), rounding);
    EXPECT_LE((track.material(1.5 * spacing) - (entry + spacing * down + 0.5 * spacing * aside)).norm(), rounding);
    (void)track.reach(2.2 * spacing, down);
    EXPECT_LE((track.node(2) - (entry + spacing * (down + aside))).norm(), rounding);
}

TEST(Track, IsOnePathWithoutGaps) {
    Track track = begun();
    (void)track.reach(1.5 * spacing, aside);
    (void)track.reach(2.5 * spacing, down);
    constexpr double step = 1e-5;    // [m]
    for (double way = 0.0; way < 3.0 * spacing; way += step) {
        const double apart = (track.material(way + step) - track.material(way)).norm();
        EXPECT_LE(apart, step * (1.0 + 1e-9)) << way;    // rounding
        EXPECT_GE(apart, 0.9 * step) << way;             // a chord over the kink of 37°
    }
}

TEST(Track, IsCoveredUpToTheTip) {
    Track track = begun();
    (void)track.reach(2.5 * spacing, down);
    EXPECT_NEAR(track.covered(0, 2.5 * spacing), spacing, rounding);
    EXPECT_NEAR(track.covered(2, 2.5 * spacing), 0.5 * spacing, rounding);
    EXPECT_NEAR(track.covered(1, 1.25 * spacing), 0.25 * spacing, rounding);    // the needle drawn back
    EXPECT_EQ(track.covered(2, 1.25 * spacing), 0.0);
    EXPECT_LE((track.covered_span(2, 2.5 * spacing) - 0.5 * spacing * down).norm(), rounding);
}

TEST(Track, BeyondTheTissueCutsAndCoversNothing) {
    Track track = begun();
    (void)track.reach(1.5 * spacing, down);
    track.leave(1.5 * spacing);
    EXPECT_EQ(track.reach(2.5 * spacing, down), 0.0);
    EXPECT_NEAR(track.covered(1, 2.5 * spacing), 0.5 * spacing, rounding);
    EXPECT_EQ(track.covered(2, 2.5 * spacing), 0.0);
    track.leave(2.0 * spacing);    // it left where it first did
    EXPECT_NEAR(track.covered(1, 2.5 * spacing), 0.5 * spacing, rounding);
}

TEST(Track, BeginsAnewElsewhere) {
    Track track = begun();
    (void)track.reach(3.0 * spacing, down);
    track.leave(2.0 * spacing);
    track.begin(entry + Vector3::UnitY(), aside);
    EXPECT_EQ(track.nodes(), 1);
    EXPECT_EQ(track.cut(), 0.0);
    EXPECT_NEAR(track.reach(3.0 * spacing, aside), 3.0 * spacing, rounding);
}

TEST(Track, GrowsWithoutMemoryAndEndsAtItsMostNodes) {
    Track track = begun();
    const std::size_t before = contract::allocations();
    const double fresh = track.reach(10.0 * most_nodes * spacing, down);
    EXPECT_EQ(contract::allocations(), before);
    EXPECT_NEAR(fresh, 10.0 * most_nodes * spacing, rounding);
    EXPECT_EQ(track.nodes(), most_nodes);
}

}    // namespace
}    // namespace stylet::core
