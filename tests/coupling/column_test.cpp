// The coupling against a column that buckles by itself: what a rod needle will ask of it.
#include "core/coupling/coupling.h"
#include "core/ledger/ledger.h"

#include <gtest/gtest.h>

#include "planar_column.h"

#include <cmath>
#include <cstdio>
#include <limits>

namespace stylet::core {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The paper's needle: steel, 200 mm long, of radius 0.3 mm.
constexpr double length = 0.2;                    // [m]
constexpr double axial_stiffness = 5.65e4;        // [N]
constexpr double bending_stiffness = 1.272e-3;    // [N·m²]
constexpr double line_density = 2.2e-3;           // [kg/m]
// First root of tan x = x, squared: a column clamped at one end and pinned at the other (Timoshenko and Gere 1961, §2.1).
constexpr double clamped_pinned = 20.190729;
constexpr double critical_load = clamped_pinned * bending_stiffness / (length * length);    // [N] 0.642

ColumnSetup column_of(int elements, double side_force) {
    return {.length = length,
            .axial_stiffness = axial_stiffness,
            .bending_stiffness = bending_stiffness,
            .line_density = line_density,
            .side_force = side_force,
            .elements = elements};
}

/// A column whose tip stands on a spring, as outside before a rupture: sideways and axially it sticks.
class Push {
public:
    Push(const ColumnSetup& setup, const Vector3& tissue_compliance)
        : column(setup, base_at(0.0)), tissue(tissue_compliance), setup_(setup) {
        contacts.points.push_back({.material = Vector3::Zero(), .span = Vector3::Zero(), .arclength = length, .tip = true});
        contacts.rows.emplace_back();
        column.predict(base_at(0.0), length, 0.0);
    }

    static Pose base_at(double pushed) { return {.position = {0.0, 0.0, length - pushed}}; }

    void predict(double pushed, double dt) {
        const Vector3 before = column.position(length);
        column.predict(base_at(pushed), setup_.length, dt);
        const Vector3 axis = column.tangent(length);
        ContactRow& row = contacts.rows.front();
        row = {.lateral = true,
               .lower = -infinity,
               .upper = infinity,
               .old_force = row.force,
               .old_effect_force = row.effect_force,
               .old_sideways = row.sideways,
               .old_position = before};
        row.frame.col(2) = -axis;
        row.frame.col(1) = Vector3::UnitY();
        row.frame.col(0) = Vector3::UnitY().cross(-axis);
        relocation = coupling.carry(tissue, contacts);
        tissue.predict(dt);
    }
    CouplingReport solve(double pushed, double dt) {
        predict(pushed, dt);
        return coupling.solve(column, tissue, contacts, {}, infinity, dt);
    }
    void commit() {
        column.commit();
        tissue.commit();
        coupling.commit();
    }
    void rollback() {
        column.rollback();
        tissue.rollback();
    }
    /// From where the tissue is under its forces to where the needle is, at each contact [m].
    [[nodiscard]] VectorX distances() {
        const Linearisation tissue_now = tissue.linearise(contacts.points, 0.0);
        VectorX forces(tissue_now.free.size()), apart(tissue_now.free.size());
        for (std::size_t i = 0; i < contacts.rows.size(); ++i) {
            forces.segment<3>(3 * static_cast<Eigen::Index>(i)) = contacts.rows[i].force;
            apart.segment<3>(3 * static_cast<Eigen::Index>(i)) = column.position(contacts.points[i].arclength);
        }
        return apart - tissue_now.free + tissue_now.compliance * forces;
    }
    [[nodiscard]] double hand_force() const { return -column.base_wrench().force.z(); }

    PlanarColumn column;
    SpringTissue tissue;
    Coupling coupling;
    ContactSet contacts;
    double relocation = 0.0;    // [J] of the last step

private:
    ColumnSetup setup_;
};

const Vector3 rigid_pin(1e-9, 1e-9, 1e-9);    // [m/N] stiffer than the needle by a thousand, along it

/// Base travel that puts the straight column under this load on a rigid pin.
double push_for(double load) {
    return load * (length / axial_stiffness + rigid_pin.z());
}

// ---- the column itself -----------------------------------------------------------------------------------------------------

/// The compression at which the tangent of the straight column, tip held sideways, first has a direction without stiffness.
double critical_load_of_tangent(int elements) {
    const PlanarColumn column(column_of(elements, 0.0), Push::base_at(0.0));
    double stable = 0.5 * critical_load, unstable = 1.5 * critical_load;
    for (int i = 0; i < 50; ++i) {
        const double load = 0.5 * (stable + unstable);
        const MatrixX tangent =
            column.straight_tangent(load).topLeftCorner(2 * elements - 1, 2 * elements - 1);    // without the tip's last
        const double least = Eigen::SelfAdjointEigenSolver<MatrixX>(tangent, Eigen::EigenvaluesOnly).eigenvalues()[0];
        (least > 0.0 ? stable : unstable) = load;
    }
    return stable;
}

TEST(Column, HasTheCriticalLoadOfAClampedPinnedOneBySecondOrder) {
    const double coarse = critical_load_of_tangent(20) / critical_load - 1.0;
    const double fine = critical_load_of_tangent(40) / critical_load - 1.0;
    std::printf("critical load of the tangent: %+.3f %% with 21 nodes, %+.3f %% with 41\n", 100.0 * coarse, 100.0 * fine);
    constexpr double figures = 5e-4;    // the prototype's table (coupling_findings.md) has two figures: −0.5 % and −0.13 %
    EXPECT_NEAR(coarse, -0.005, figures);
    EXPECT_NEAR(fine, -0.0013, figures / 5.0);
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.05);    // the order, up to its next term
}

// ---- the branch --------------------------------------------------------------------------------------------------------------

constexpr double large_step = 5e-3;    // [s] inertia can't hold twice the critical load straight for that long
constexpr double tiny_force = 1e-7;    // [N] bows the unloaded column by some 6 nm
constexpr double straight = 1e-6;      // [m]
constexpr double twice = 2.2;          // times the critical load, as in the prototype's finding 2

/// Newton's method on both bodies with a tip that neither slides nor slips, without a look at the branch.
double newton_residual(Push& push, double pushed, double dt) {
    push.predict(pushed, dt);
    double residual = infinity;
    for (int i = 0; i < 20 && residual > Coupling::tolerance; ++i) {
        const Linearisation needle = push.column.linearise(push.contacts.points, 0.0);
        const Linearisation tissue = push.tissue.linearise(push.contacts.points, 0.0);
        const MatrixX compliance = needle.compliance + tissue.compliance;
        const VectorX forces = compliance.fullPivLu().solve(tissue.free - needle.free);
        const VectorX opposite = -forces;
        residual = push.column.try_step(push.contacts.points, Forces(forces.data(), 3)).residual;
        (void)push.tissue.try_step(push.contacts.points, Forces(opposite.data(), 3));
    }
    return residual;
}

TEST(Branch, NewtonAloneStaysStraightAboveTheCriticalLoad) {
    Push push(column_of(20, tiny_force), rigid_pin);
    EXPECT_LE(newton_residual(push, push_for(twice * critical_load), large_step), Coupling::tolerance);
    EXPECT_LT(std::abs(push.column.bow()), straight);
}

TEST(Branch, TheCouplingBowsWhereNewtonStaysStraight) {
    Push push(column_of(20, tiny_force), rigid_pin);
    const CouplingReport report = push.solve(push_for(twice * critical_load), large_step);
    EXPECT_TRUE(report.converged);
    EXPECT_LE(report.residual, Coupling::tolerance);
    EXPECT_GT(push.column.bow(), 100.0 * straight);
    EXPECT_LT(push.contacts.rows[0].axial_force, 0.7 * twice * critical_load);    // what inertia still holds; bowed, it yields
}

TEST(Branch, IsTheBowedOneFromAnyImperfection) {
    double least = infinity, most = 0.0;
    for (const double side_force : {1e-7, 1e-6, 1e-5, 1e-4}) {
        Push push(column_of(20, side_force), rigid_pin);
        EXPECT_TRUE(push.solve(push_for(twice * critical_load), large_step).converged) << side_force << " N";
        least = std::min(least, push.column.bow());
        most = std::max(most, push.column.bow());
    }
    constexpr double of_the_imperfection = 0.02;    // the largest is worth 6 µm of a bow of 330 µm
    EXPECT_LT(most - least, of_the_imperfection * most);
}

TEST(Branch, APerfectlyStraightColumnIsNotAcceptedAboveItsLoad) {
    Push push(column_of(20, 0.0), rigid_pin);
    EXPECT_FALSE(push.solve(push_for(twice * critical_load), large_step).converged);
    push.rollback();
    // In a step too short for the bow to grow, inertia holds it straight: that branch is then the right one.
    EXPECT_TRUE(push.solve(push_for(twice * critical_load), 0.25 * large_step).converged);
    EXPECT_EQ(push.column.bow(), 0.0);
}

TEST(Branch, WithoutTimeAnUnstableColumnIsRefused) {
    Push push(column_of(20, tiny_force), rigid_pin);
    EXPECT_FALSE(push.solve(push_for(twice * critical_load), 0.0).converged);
    push.rollback();
    EXPECT_TRUE(push.solve(push_for(0.9 * critical_load), 0.0).converged);
}

// ---- a run -----------------------------------------------------------------------------------------------------------------

struct Run {
    double load_at_bow = 0.0;          // [N] hand force when the bow passes one per cent of the length
    int most_linearisations = 0;       // in a tick
    int refused = 0;                   // ticks that did not converge
    double relative_residual = 0.0;    // largest residual of the ledger, of the peak work
};

/// A hand at 10 mm/s and 1 kHz onto a soft dent, until the needle is well bowed.
Run run() {
    constexpr double dt = 1e-3, speed = 0.01;    // [s], [m/s]
    constexpr double side_force = 3.4e-4;        // [N] bows the unloaded column by 1e-4 of its length
    Push push(column_of(20, side_force), Vector3(1e-3, 1e-3, 1e-2));
    Ledger ledger;
    Run seen;
    for (int tick = 1; tick <= 1500; ++tick) {
        const double pushed = tick * dt * speed;
        const CouplingReport report = push.solve(pushed, dt);
        seen.refused += !report.converged;
        seen.most_linearisations = std::max(seen.most_linearisations, report.linearisations);
        HandStep hand{.before = Push::base_at(pushed - dt * speed),
                      .after = Push::base_at(pushed),
                      .wrench_before = push.column.base_wrench(),
                      .wrench_after = {}};
        push.commit();
        hand.wrench_after = push.column.base_wrench();
        ledger.close(hand, push.contacts, {.relocation = push.relocation}, push.column, push.tissue);
        if (seen.load_at_bow == 0.0 && push.column.bow() > 0.01 * length) seen.load_at_bow = push.hand_force();
    }
    seen.relative_residual = ledger.peak_residual() / ledger.peak_work();
    return seen;
}

const Run& the_run() {
    static const Run seen = run();
    return seen;
}

TEST(PushedColumn, BucklesAtTheCriticalLoad) {
    std::printf("bow of 1 %% of the length at %.4f of the critical load\n", the_run().load_at_bow / critical_load);
    // A run blurs the bifurcation: the imperfection rounds it off below, inertia lets the load run ahead of the bow above
    // (the prototype saw .93 to 1.12 for imperfections of 1e-3 to 1e-6 of the length), and the discrete column lacks 0.5 %.
    constexpr double blur = 0.05;
    EXPECT_NEAR(the_run().load_at_bow / critical_load, 1.0, blur);
}

TEST(PushedColumn, ConvergesInAtMostSixLinearisations) {
    EXPECT_EQ(the_run().refused, 0);
    EXPECT_LE(the_run().most_linearisations, 6);
}

TEST(PushedColumn, MakesNoEnergy) {
    std::printf("ledger: %.1e of the peak work, %d linearisations at most\n", the_run().relative_residual,
                the_run().most_linearisations);
    constexpr double quadrature =
        1e-4;    // the trapezoid rule across the sudden bow, 1 ms steps; ten times below the house's bound
    EXPECT_LE(the_run().relative_residual, quadrature);
}

// ---- shaft contacts --------------------------------------------------------------------------------------------------------

TEST(HeldShaft, LiesWhereTheTissueIsAndSticksOrSlipsByItsLimits) {
    constexpr double dt = 1e-3, friction_limit = 0.05, rupture = 0.4;    // [s], [N], [N]
    const Vector3 springs(2e-3, 2e-3, 1e-2);                             // [m/N]
    Push push(column_of(20, 1e-4), springs);
    const ContactRow tip_row = push.contacts.rows.front();
    for (const double behind : {0.01, 0.02, 0.03}) {
        push.contacts.points.push_back(
            {.material = {0.0, 0.0, behind}, .span = {0.0, 0.0, -0.01}, .arclength = length - behind, .tip = false});
        push.contacts.rows.push_back(tip_row);
    }
    bool stuck_once = false, slipped_once = false;
    for (int tick = 1; tick <= 60; ++tick) {
        push.predict(2e-4 * tick, dt);
        ContactRow& tip = push.contacts.rows.front();
        const ContactRow frame = tip;
        for (ContactRow& row : push.contacts.rows) {
            row = frame;
            row.lower = -friction_limit;
            row.upper = friction_limit;
        }
        tip.lower = 0.0;
        tip.upper = rupture;
        ASSERT_TRUE(push.coupling.solve(push.column, push.tissue, push.contacts, {}, infinity, dt).converged) << "tick " << tick;
        const VectorX apart = push.distances();
        for (int i = 0; i < 4; ++i) {
            const ContactRow& row = push.contacts.rows[i];
            const Vector3 local = row.frame.transpose() * apart.segment<3>(3 * i);
            constexpr double rounding = 1e-11;    // [m] 1e-9 N, the coupling's tolerance, through the softest spring
            EXPECT_LT(local.head<2>().norm(), rounding);
            EXPECT_NEAR(local.z(), -row.advance, rounding);
            EXPECT_LE(row.axial_force, row.upper);
            EXPECT_GE(row.axial_force, row.lower);
            if (row.advance > 0.0) {
                EXPECT_EQ(row.axial_force, row.upper);
            }
            (row.advance == 0.0 ? stuck_once : slipped_once) = true;
        }
        push.commit();
    }
    EXPECT_TRUE(stuck_once);
    EXPECT_TRUE(slipped_once);
}

}    // namespace
}    // namespace stylet::core
