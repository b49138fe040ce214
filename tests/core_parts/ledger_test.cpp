#include "core/ledger/ledger.h"

#include <gtest/gtest.h>

#include "still_bodies.h"

#include <numbers>

namespace stylet::core {
namespace {

constexpr double rounding = 1e-15;    // [J] of energies of some millijoules

struct Books {
    Ledger ledger;
    StraightNeedle needle{0.2};
    StillTissue tissue{0.02, 0.1};
    ContactSet contacts;

    void add_contact(bool tip, double old_force, double force, double advance) {
        contacts.points.push_back({.material = Vector3::Zero(), .span = Vector3::Zero(), .arclength = 0.2, .tip = tip});
        contacts.rows.push_back({});
        ContactRow& row = contacts.rows.back();
        row.old_effect_force = old_force * row.frame.col(2);
        row.effect_force = force * row.frame.col(2);
        row.advance = advance;
    }
    /// A hand that goes straight down.
    void close(double travel, double force_before, double force_after, double fracture = 0.0, double relocation = 0.0) {
        HandStep hand;
        hand.after.position = {0.0, 0.0, -travel};
        hand.wrench_before.force = {0.0, 0.0, -force_before};
        hand.wrench_after.force = {0.0, 0.0, -force_after};
        ledger.close(hand, contacts, {.relocation = relocation, .fracture = fracture}, needle, tissue);
        contacts.clear();
    }
};

TEST(Ledger, FindsAPushedSpringsEnergyInBothBodies) {
    constexpr double stiffness = 200.0, travel = 5e-3;    // [N/m], [m]: two springs in a row, three quarters in the needle
    Books books;
    for (int step = 1; step <= 10; ++step) {
        const double before = 0.1 * travel * (step - 1), after = 0.1 * travel * step;
        books.needle.report.stored = 0.75 * 0.5 * stiffness * after * after;
        books.tissue.report.stored = 0.25 * 0.5 * stiffness * after * after;
        books.close(after - before, stiffness * before, stiffness * after);
        EXPECT_NEAR(books.ledger.balance().residual(), 0.0, rounding);
    }
    EXPECT_NEAR(books.ledger.balance().hand_work, 2.5e-3, rounding);
    EXPECT_NEAR(books.ledger.balance().stored, 2.5e-3, rounding);
    EXPECT_NEAR(books.ledger.peak_work(), 2.5e-3, rounding);
}

// The example of a rupture in closed form: 0.2 N/mm, 1 N, 164 J/m², r = 0.3 mm. The tip jumps until the spring carries no more
// than cutting takes, and (F_r − F_c)²/2k is lost.
TEST(Ledger, LosesTheKnownEnergyAtARupture) {
    constexpr double stiffness = 200.0, rupture = 1.0;                     // [N/m], [N]
    constexpr double cutting = 2.0 * std::numbers::pi * 0.3e-3 * 164.0;    // [N]
    constexpr double jump = (rupture - cutting) / stiffness;               // [m]
    Books books;
    books.tissue.report.stored = 0.5 * rupture * rupture / stiffness;
    books.close(rupture / stiffness, 0.0, rupture);
    books.tissue.report.stored = 0.5 * cutting * cutting / stiffness;
    books.add_contact(true, rupture, cutting, jump);
    books.close(0.0, rupture, cutting, cutting * jump);
    EXPECT_NEAR(jump, 3.454e-3, 1e-6);                            // [m] all the digits that are printed
    EXPECT_NEAR(books.ledger.balance().burst, 1.193e-3, 1e-6);    // [J] as well
    EXPECT_NEAR(books.ledger.balance().burst, 0.5 * stiffness * jump * jump, rounding);
    EXPECT_NEAR(books.ledger.balance().fracture, cutting * jump, rounding);
    EXPECT_NEAR(books.ledger.balance().residual(), 0.0, rounding);
}

TEST(Ledger, CountsTheShaftsSlipAsFriction) {
    Books books;
    books.add_contact(true, 0.0, 0.0, 2e-3);
    books.add_contact(false, 0.1, 0.3, 2e-3);
    books.add_contact(false, -0.1, -0.1, -1e-3);
    books.close(0.0, 0.0, 0.0);
    EXPECT_NEAR(books.ledger.balance().friction, 0.4e-3 + 0.1e-3, rounding);
    EXPECT_EQ(books.ledger.balance().burst, 0.0);
}

TEST(Ledger, CountsAHandThatTurns) {
    Books books;
    HandStep hand;
    hand.after.rotation = Quaternion(Eigen::AngleAxisd(0.1, Vector3::UnitX()));
    hand.wrench_before.moment = {0.01, 5.0, 0.0};
    hand.wrench_after.moment = {0.03, 5.0, 0.0};
    books.ledger.close(hand, books.contacts, {}, books.needle, books.tissue);
    EXPECT_NEAR(books.ledger.balance().hand_work, 0.02 * 0.1, rounding);
}

TEST(Ledger, TakesMotionAndLossesFromTheBodies) {
    Books books;
    books.needle.report = {.stored = 1e-3, .kinetic = 2e-3, .damping = 4e-3, .numerical = 8e-3};
    books.tissue.report = {.stored = 1e-4, .kinetic = 2e-4, .damping = 4e-4, .numerical = 8e-4};
    books.close(1.0, 16.5e-3, 16.5e-3);
    EXPECT_NEAR(books.ledger.balance().kinetic, 2.2e-3, rounding);
    EXPECT_NEAR(books.ledger.balance().damping, 4.4e-3, rounding);
    EXPECT_NEAR(books.ledger.balance().numerical, 8.8e-3, rounding);
    EXPECT_NEAR(books.ledger.balance().residual(), 0.0, rounding);
}

TEST(Ledger, CallsReleasedWhatMovedContactPointsSetFree) {
    Books books;
    books.add_contact(false, 0.0, 0.0, 0.0);
    ContactRow& row = books.contacts.rows.back();
    row.frame.col(0) = Vector3::UnitY();
    row.frame.col(1) = -Vector3::UnitX();
    row.old_force = {0.0, 1.0, 0.0};
    row.force = {0.0, 3.0, 0.0};
    row.carried_over = {1e-3, 0.0, 0.0};    // in the frame: world y
    books.close(0.0, 0.0, 0.0, 0.0, -5e-3);
    EXPECT_NEAR(books.ledger.balance().released, 5e-3 - 2e-3, rounding);
}

TEST(Ledger, KeepsTheLargestResidual) {
    Books books;
    books.needle.report.stored = 3e-3;    // from nowhere
    books.close(0.0, 0.0, 0.0);
    books.needle.report.stored = 0.0;
    books.close(0.0, 0.0, 0.0);
    EXPECT_EQ(books.ledger.balance().residual(), 0.0);
    EXPECT_NEAR(books.ledger.peak_residual(), 3e-3, rounding);
}

TEST(Ledger, ForetellsTheResidualOfAStepAtRest) {
    Books books;
    books.tissue.report.stored = 2e-3;
    books.close(1.0, 2e-3, 2e-3);
    books.tissue.report.stored = 1e-3;
    books.add_contact(true, 1.0, 0.5, 1e-3);
    const double foretold = books.ledger.imbalance_at_rest(books.contacts, {}, books.needle, books.tissue);
    EXPECT_NEAR(foretold, 1e-3 - 0.75e-3, rounding);
    const double before = books.ledger.balance().residual();
    books.close(0.0, 1.0, 0.5, 0.3e-3);
    EXPECT_NEAR(books.ledger.balance().residual() - before, foretold, rounding);
}

}    // namespace
}    // namespace stylet::core
