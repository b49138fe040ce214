#include "bowed_arc.h"
#include "elastica_curve.h"

#include <stylet/contract/contract.h>
#include <stylet/needle_model.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

namespace stylet {
namespace {

using contract::Case;
using elastica::all_ends;
using elastica::ElasticaCurve;
using elastica::names;
using std::numbers::pi;

NeedleSetup steel(Ends ends) {
    NeedleSetup needle = contract::steel_needle();
    needle.ends = ends;
    return needle;
}

/// 0.9 of what the ends make of it, so that a test knows whose load was used.
struct Weaker final : BucklingModel {
    double critical_load(const Column& column) const override {
        const double length = std::max(column.free_length, column.radius);
        return 0.9 * ElasticaCurve::of(column.ends).own_factor() * column.bending_stiffness / (length * length);
    }
};
const Weaker weaker;

// Bowed at both of the contract's depths, and a clamped-pinned one below its limit load at both.
STYLET_CONTRACT(Case{.name = "Straight", .load = 0.3}, Case{.name = "ClampedPinned", .depth = 5e-3, .load = 0.65},
                Case{.name = "ClampedFree", .needle = steel(Ends::clamped_free), .load = 0.1},
                Case{.name = "PinnedPinned", .needle = steel(Ends::pinned_pinned), .load = 0.35},
                Case{.name = "ClampedClamped", .needle = steel(Ends::clamped_clamped), .load = 1.4},
                Case{.name = "WithABucklingModel", .needle = steel(Ends::pinned_pinned), .buckling = &weaker, .load = 0.35})

/// A needle straight down, its tip on the surface.
struct Pressed {
    explicit Pressed(Ends ends, const BucklingModel* buckling = nullptr, bool tissue = true)
        : with{.needle = steel(ends), .has_tissue = tissue, .buckling = buckling},
          needle(contract::make<NeedleModel>(STYLET_PLUGIN_FILE, with)) {
        needle->predict(base, length, dt);
        needle->commit();
    }

    /// By a force of so many newtons, whatever it does. Leans on a shift where the bow is unstable, as the coupling does.
    [[nodiscard]] bool by(double newtons) {
        return balance([newtons](const Seen&) { return newtons; }, [](const Seen& seen) { return seen.negatives == 0; });
    }

    /// By a spring of this stiffness [N/m] whose other end is moved `way` [m] down from where it only touches the tip. Stable
    /// where the two compliances together have as many negatives as the needle.
    [[nodiscard]] bool by_spring(double stiffness, double way) {
        return balance([=](const Seen& seen) { return (way - seen.free) / (seen.compliance + 1.0 / stiffness); },
                       [=](const Seen& seen) { return (seen.compliance + 1.0 / stiffness < 0.0) == (seen.negatives > 0); });
    }

    [[nodiscard]] double critical_load() const { return needle->state().critical_load; }
    [[nodiscard]] double shortening() const { return needle->held_position(length).z(); }    // [m] the tip's way up

    static constexpr double length = 0.2, dt = 1e-3;    // [m], [s]
    const Pose base{Vector3(0.0, 0.0, length), Quaternion::Identity()};
    const ContactPoint tip{Vector3::Zero(), Vector3::Zero(), length, true};
    Case with;
    std::unique_ptr<NeedleModel> needle;

private:
    /// Of the tip, along the needle.
    struct Seen {
        double free, compliance;
        int negatives;
    };

    [[nodiscard]] Seen look(double shift) {
        const Linearisation found = needle->linearise({&tip, 1}, shift);
        return {found.free[2], found.compliance(2, 2), found.negatives};
    }

    /// Newton; with the least shift that makes it stable.
    template <class Force, class Stable>
    [[nodiscard]] bool balance(Force force_of, Stable stable) {
        for (int step = 0; step < 100; ++step) {
            double shift = 0.0;
            Seen seen = look(shift);
            while (!stable(seen)) seen = look(shift = std::max(0.25 / (dt * dt), 2.0 * shift));
            const VectorX force = (VectorX(3) << 0.0, 0.0, force_of(seen)).finished();
            const StepReport report = needle->try_step({&tip, 1}, {force.data(), 3});
            if (shift > 0.0 || report.residual > 1e-12 || report.tangent_changed) continue;
            needle->commit();
            return true;
        }
        return false;
    }
};

TEST(Elastica, HasEulersLoadOfItsEndsOfItsOwn) {
    constexpr double printed = 5e-4;    // paper_findings, Fig. 10: clamped-free, pinned-pinned, clamped-pinned, clamped-clamped
    const double loads[] = {0.078, 0.314, 0.642, 1.256};
    for (std::size_t i = 0; i < all_ends.size(); ++i) EXPECT_NEAR(Pressed(all_ends[i]).critical_load(), loads[i], printed);
}

TEST(Elastica, TakesTheLoadOfTheScenesModelWhereThereIsOne) {
    Pressed own(Ends::clamped_pinned), given(Ends::clamped_pinned, &weaker);
    EXPECT_DOUBLE_EQ(given.critical_load(), 0.9 * own.critical_load());
    ASSERT_TRUE(own.by(1.1 * own.critical_load()));
    ASSERT_TRUE(given.by(1.1 * given.critical_load()));
    EXPECT_NEAR(given.needle->state().deflection, own.needle->state().deflection, 1e-12 * Pressed::length);
}

TEST(Elastica, BowsSmoothlyFromItsCriticalLoadOn) {
    // Hard case 13: the deflection goes to nothing as the root of what the load is above the critical one.
    for (std::size_t i = 0; i < all_ends.size(); ++i) {
        double ratio = 0.0;
        for (int k = 2; k <= 12; ++k) {
            const double above = std::pow(10.0, -k);
            Pressed below(all_ends[i]), bowed(all_ends[i]);
            ASSERT_TRUE(below.by(below.critical_load() * (1.0 - above)));
            ASSERT_TRUE(bowed.by(bowed.critical_load() * (1.0 + above)));
            EXPECT_FALSE(below.needle->state().buckled);
            EXPECT_EQ(below.needle->state().deflection, 0.0);
            EXPECT_TRUE(bowed.needle->state().buckled) << k;
            const double now = bowed.needle->state().deflection / std::sqrt(above) / Pressed::length;
            // The next term is of the order of what is above; below that 1 + 1e-12 itself is rounded by 1e-4 of it.
            if (k > 2) {
                EXPECT_NEAR(now / ratio, 1.0, 20.0 * above + 2e-16 / above) << names[i] << " " << k;
            }
            ratio = now;
        }
        std::printf("%-15s deflection/L → %.4f √(P/P_cr − 1)\n", names[i], ratio);
    }
}

TEST(Elastica, ComesBackTheWayItWent) {
    // Hard case 16, below the limit load.
    for (const Ends ends : all_ends) {
        Pressed needle(ends);
        std::vector<double> bows;
        for (int i = 0; i <= 40; ++i) {
            ASSERT_TRUE(needle.by(needle.critical_load() * (0.9 + 0.23 * i / 40.0)));
            bows.push_back(needle.needle->state().deflection);
        }
        for (int i = 40; i >= 0; --i) {
            ASSERT_TRUE(needle.by(needle.critical_load() * (0.9 + 0.23 * i / 40.0)));
            EXPECT_NEAR(needle.needle->state().deflection, bows[i], 1e-6 * Pressed::length) << i;
        }
        EXPECT_FALSE(needle.needle->state().buckled);
        EXPECT_EQ(needle.needle->energy().stored, 0.0);
        EXPECT_EQ(needle.needle->energy().numerical, 0.0);
    }
}

TEST(Elastica, FoldsUpUnderALoadThatItCannotCarry) {
    Pressed needle(Ends::clamped_pinned);
    const double critical = needle.critical_load();
    ASSERT_TRUE(needle.by(1.139 * critical));
    EXPECT_EQ(needle.needle->energy().numerical, 0.0);
    const double before = needle.shortening(), stored = needle.needle->energy().stored;
    ASSERT_TRUE(needle.by(1.141 * critical));
    const EnergyReport after = needle.needle->energy();
    std::printf("past its limit load: from %.1f mm to %.1f mm, %.2f mJ of %.2f mJ lost\n", 1e3 * before,
                1e3 * needle.shortening(), 1e3 * after.numerical, 1e3 * 1.14 * critical * (needle.shortening() - before));
    EXPECT_NEAR(needle.shortening() / Pressed::length, ElasticaCurve::of(Ends::clamped_pinned).folded(), 0.002);
    EXPECT_STREQ(needle.needle->beyond_validity(), "beyond validity: the needle is folded up");
    constexpr double steps = 2e-3;    // of the work: the load grew by that much within the step
    const double work = 1.14 * critical * (needle.shortening() - before);
    EXPECT_NEAR(after.stored - stored + after.numerical, work, steps * work);
    EXPECT_GT(after.numerical, 0.1 * work);
    ASSERT_TRUE(needle.by(0.01 * critical));    // folded, it takes hardly a force to keep it so
    EXPECT_TRUE(needle.needle->state().buckled);
    ASSERT_TRUE(needle.by(0.0));    // but let go it springs open
    EXPECT_FALSE(needle.needle->state().buckled);
    EXPECT_EQ(needle.shortening(), 0.0);
}

TEST(Elastica, IsStableOnItsFallingBranchWhereASpringHoldsIt) {
    Pressed needle(Ends::clamped_pinned);
    constexpr double stiffness = 200.0;    // [N/m] more than the steepest fall, 11.7 P_cr/L = 37 N/m
    for (double way = 0.0; way < 0.16; way += 1e-3) {
        ASSERT_TRUE(needle.by_spring(stiffness, way)) << way;
        const double eta = needle.shortening() / Pressed::length;
        if (eta > 0.46) {
            const Linearisation found = needle.needle->linearise({&needle.tip, 1}, 0.0);
            EXPECT_EQ(found.negatives, 1);
            EXPECT_LT(found.compliance(2, 2), 0.0);
        }
    }
    EXPECT_GT(needle.shortening() / Pressed::length, 0.75);
    EXPECT_EQ(needle.needle->energy().numerical, 0.0) << "it snapped";
}

TEST(Elastica, SnapsToTheNextStableBowWhereItsSpringIsTooSoft) {
    // Hard case 17. The spring is linear, so that work, stored energy and loss must add up exactly.
    Pressed needle(Ends::clamped_pinned);
    constexpr double stiffness = 10.0;    // [N/m] less than the steepest fall
    double total = 0.0, lost = 0.0, largest = 0.0, force = 0.0;
    for (double way = 0.0; way < 0.25; way += 1e-4) {
        const double before = needle.shortening();
        ASSERT_TRUE(needle.by_spring(stiffness, way)) << way;
        const double now = needle.needle->state().axial_load;
        total += 0.5 * (force + now) * (needle.shortening() - before);    // what the spring has given
        largest = std::max(largest, needle.needle->energy().numerical - lost);
        lost = needle.needle->energy().numerical;
        force = now;
    }
    std::printf("with a spring of %.0f N/m it snaps once and loses %.3f mJ\n", stiffness, 1e3 * lost);
    EXPECT_GT(lost, 0.0);
    EXPECT_DOUBLE_EQ(largest, lost) << "more than one snap";
    constexpr double trapezoids = 1e-5;    // of the work, over 2500 steps
    EXPECT_NEAR(needle.needle->energy().stored + lost, total, trapezoids * total);
    EXPECT_STREQ(needle.needle->beyond_validity(), "beyond validity: the needle is folded up");
}

TEST(Elastica, IsBoundedUnderAnyLoadAndSaysSo) {
    // Hard case 18.
    for (const Ends ends : all_ends) {
        Pressed needle(ends);
        ASSERT_TRUE(needle.by(1e3 * needle.critical_load()));
        EXPECT_STREQ(needle.needle->beyond_validity(), "beyond validity: the needle is folded up");
        EXPECT_LT(needle.shortening(), 2.0 * Pressed::length);
        EXPECT_LE(needle.needle->state().deflection, Pressed::length);
    }
}

TEST(Elastica, SaysWhenItsBowWouldLieOnTheTissueOrMeetsItself) {
    // f = (2K/π)² is 1.3932 at 90°, and at η = 0.8488 it is larger than 1.7 (clamped-clamped).
    Pressed below(Ends::pinned_pinned), above(Ends::pinned_pinned), in_air(Ends::pinned_pinned, nullptr, false);
    ASSERT_TRUE(below.by(1.393 * below.critical_load()));
    ASSERT_TRUE(above.by(1.394 * above.critical_load()));
    ASSERT_TRUE(in_air.by(1.394 * in_air.critical_load()));
    EXPECT_EQ(below.needle->beyond_validity(), nullptr);
    EXPECT_STREQ(above.needle->beyond_validity(),
                 "beyond validity: the needle's slope is over 90°, its bow would lie on the tissue");
    EXPECT_EQ(in_air.needle->beyond_validity(), nullptr);
    Pressed bulging(Ends::clamped_clamped, nullptr, false);
    const double touching = ElasticaCurve::of(Ends::clamped_clamped).at(0.8488).load;
    ASSERT_TRUE(bulging.by(0.999 * touching * bulging.critical_load()));
    EXPECT_EQ(bulging.needle->beyond_validity(), nullptr);
    ASSERT_TRUE(bulging.by(1.001 * touching * bulging.critical_load()));
    EXPECT_STREQ(bulging.needle->beyond_validity(), "beyond validity: the needle's bow meets itself");
}

TEST(Elastica, KeepsItsLengthWhileItBows) {
    for (const Ends ends : all_ends) {
        Pressed needle(ends);
        ASSERT_TRUE(needle.by(1.1 * needle.critical_load()));
        constexpr int count = 4001;
        std::vector<Vector3> line(count);
        needle.needle->centreline(line);
        double length = 0.0;
        for (int i = 1; i < count; ++i) length += (line[i] - line[i - 1]).norm();
        constexpr double chords = 3e-7;    // shorter than their arcs by (κh)²/24; the tables add 1e-9
        EXPECT_NEAR(length / Pressed::length, 1.0, chords);
        EXPECT_NEAR(line.back().z(), needle.shortening(), 1e-9 * Pressed::length);
        const double aside = line.back().x();
        EXPECT_NEAR(aside, ends == Ends::clamped_free ? needle.needle->state().deflection : 0.0, 1e-9 * Pressed::length);
    }
}

TEST(Elastica, KeepsTheContactsOfAFreeTipOnItsLine) {
    Pressed needle(Ends::clamped_free);
    ASSERT_TRUE(needle.by(1.2 * needle.critical_load()));
    EXPECT_GT(needle.needle->position(Pressed::length).x(), 0.3 * Pressed::length);
    EXPECT_EQ(needle.needle->held_position(Pressed::length).x(), 0.0);
    EXPECT_EQ(needle.needle->position(Pressed::length).z(), needle.needle->held_position(Pressed::length).z());
}

TEST(Elastica, EntryForceIsMinusTheEnergysDerivativeInTheFreeLength) {
    constexpr double h = 1e-6 * Pressed::length, differences = 1e-8;    // h² and 1e-16/1e-6
    for (const Ends ends : all_ends) {
        Pressed needle(ends);
        ASSERT_TRUE(needle.by(1.1 * needle.critical_load()));
        const auto stored = [&needle](double length) {
            needle.needle->predict(needle.base, length, 0.0);
            return needle.needle->energy().stored;
        };
        const double derivative = (stored(Pressed::length + h) - stored(Pressed::length - h)) / (2.0 * h);
        needle.needle->predict(needle.base, Pressed::length, 0.0);
        EXPECT_NEAR(needle.needle->entry_force() / -derivative, 1.0, differences);
    }
}

TEST(Elastica, FreeLengthMayShrinkToNothing) {
    // Hard cases 19 and 20: its critical load is capped at that of a column as long as the needle is thick.
    Pressed needle(Ends::clamped_pinned);
    double before = 0.0;
    for (const double free_length : {Pressed::length, 0.1, 1e-2, 1e-3, 3e-4, 1e-4, 1e-12, 0.0}) {
        needle.needle->predict(needle.base, free_length, Pressed::dt);
        needle.needle->commit();
        EXPECT_GE(needle.critical_load(), before);
        EXPECT_TRUE(std::isfinite(needle.critical_load()));
        EXPECT_TRUE(std::isfinite(needle.needle->entry_force()));
        before = needle.critical_load();
    }
    Pressed whole(Ends::clamped_pinned), touched(Ends::clamped_pinned);
    ASSERT_TRUE(whole.by(1.1 * whole.critical_load()));
    touched.needle->predict(touched.base, Pressed::length - 1e-12, Pressed::dt);
    ASSERT_TRUE(touched.by(1.1 * whole.critical_load()));
    EXPECT_NEAR(touched.shortening(), whole.shortening(), 1e-9);
}

}    // namespace
}    // namespace stylet
