#include "checks.h"
#include "rig.h"

#include <cmath>

namespace stylet::contract {
namespace {

constexpr double rounding = 1e-12;    // of the largest value: some hundred roundings
constexpr double residual = 1e-9;     // [N] what Rig::converge leaves
constexpr double at_rest = 1e-20;     // [J] kinetic energy of a needle that stands still

/// How far a contact may be off because forces balance only to the residual [m].
double position_tolerance(const Rig& rig) {
    const MatrixX w = rig.body->linearise(rig.points, 0.0).compliance;
    return rounding * (rig.base.position.norm() + rig.length) + w.cwiseAbs().rowwise().sum().maxCoeff() * residual;
}

/// Ticks until a needle with inertia stands still, and not only where it turns back; one without does at once.
[[nodiscard]] bool stand_still(Rig& rig) {
    constexpr int long_enough = 20;
    for (int i = 0, still = 0; i < 20000; ++i) {
        if (!rig.advance(rig.load)) return false;
        still = rig.body->energy().kinetic <= at_rest ? still + 1 : 0;
        if (still == long_enough) return true;
    }
    return false;
}

VectorX rotated(const Quaternion& rotation, const VectorX& vectors) {
    VectorX result(vectors.size());
    for (Eigen::Index i = 0; i < vectors.size(); i += 3) result.segment<3>(i) = rotation * Vector3(vectors.segment<3>(i));
    return result;
}

void moves_rigidly_with_its_base(const Descriptor& plugin, const Case& with) {
    const Quaternion turn(Eigen::AngleAxisd(2.0, Vector3(0.3, -1.0, 0.7).normalized()));
    const Vector3 shift(0.02, -0.05, 0.11);
    at_both_depths(plugin, with, [&](Rig& rig) {
        Rig moved = make_rig(plugin, with, rig.length - rig.free_length, 5e-3);
        moved.base = {turn * rig.base.position + shift, turn * rig.base.rotation};
        moved.load = rotated(turn, rig.load);
        moved.predict();
        moved.body->commit();
        ASSERT_TRUE(rig.advance(rig.load));
        ASSERT_TRUE(moved.advance(moved.load));
        const double tolerance = position_tolerance(rig);
        const double force_tolerance = 10.0 * residual;    // [N]
        const VectorX expected = rotated(turn, rig.positions(rig.load)) + shift.replicate(rig.points.size(), 1);
        EXPECT_LE((moved.positions(moved.load) - expected).cwiseAbs().maxCoeff(), tolerance);
        for (const double s : {0.0, 0.4 * rig.length, rig.length}) {
            EXPECT_LE((moved.needle->position(s) - turn * rig.needle->position(s) - shift).norm(), tolerance)
                << "at " << s << " m";
            EXPECT_LE((moved.needle->tangent(s) - turn * rig.needle->tangent(s)).norm(), tolerance / rig.length + rounding);
        }
        const Wrench wrench = rig.needle->base_wrench();
        const Wrench turned = moved.needle->base_wrench();
        EXPECT_LE((turned.force - turn * wrench.force).norm(), force_tolerance);
        EXPECT_LE((turned.moment - turn * wrench.moment).norm(), force_tolerance * rig.length + rig.load.norm() * tolerance);
        EXPECT_NEAR(moved.needle->state().deflection, rig.needle->state().deflection, 10.0 * std::sqrt(rig.length * tolerance))
            << "a bow grows with the root of the shortening";
    });
}

void base_balances_the_contacts(const Descriptor& plugin, const Case& with) {
    at_both_depths(plugin, with, [](Rig& rig) {
        ASSERT_TRUE(stand_still(rig));
        const VectorX places = rig.positions(rig.load);
        Vector3 force = Vector3::Zero();
        Vector3 moment = Vector3::Zero();
        for (Eigen::Index i = 0; i < rig.load.size(); i += 3) {
            const Vector3 one = rig.load.segment<3>(i);
            force += one;
            moment += (places.segment<3>(i) - rig.base.position).cross(one);
        }
        const double tolerance = residual * static_cast<double>(rig.load.size());    // [N] each of them may be off by its own
        const Wrench wrench = rig.needle->base_wrench();
        EXPECT_LE((wrench.force + force).norm(), tolerance);
        EXPECT_LE((wrench.moment + moment).norm(), tolerance * rig.length + force.norm() * position_tolerance(rig));
        constexpr double slope_share = 0.01;    // of the load: a bow's tangent leaves the axis, and its compression with it
        EXPECT_NEAR(rig.needle->state().axial_load, wrench.force.dot(rig.axis), slope_share * force.norm());
    });
}

void places_agree(const Descriptor& plugin, const Case& with) {
    at_both_depths(plugin, with, [](Rig& rig) {
        ASSERT_TRUE(rig.advance(rig.load));
        const double tolerance = position_tolerance(rig);
        const VectorX places = rig.positions(rig.load);
        for (std::size_t i = 0; i < rig.points.size(); ++i) {
            const double s = rig.points[i].arclength;
            EXPECT_LE((rig.needle->held_position(s) - places.segment<3>(3 * i)).norm(), tolerance) << "contact " << i;
        }
        for (const double s : {0.0, 0.5 * rig.length, rig.length}) EXPECT_NEAR(rig.needle->tangent(s).norm(), 1.0, rounding);
        EXPECT_LE((rig.needle->position(0.0) - rig.base.position).norm(), tolerance);
        std::vector<Vector3> line(21);
        rig.needle->centreline(line);
        EXPECT_LE((line.front() - rig.base.position).norm(), tolerance);
        EXPECT_LE((line.back() - rig.needle->position(rig.length)).norm(), tolerance);
    });
}

void unloaded_it_is_straight(const Descriptor& plugin, const Case& with) {
    at_both_depths(plugin, with, [](Rig& rig) {
        constexpr double imperfection = 1e-3;    // of the length: a declared one is never larger
        const Vector3 tip = rig.needle->position(rig.length);
        EXPECT_LE((tip - rig.base.position - rig.length * rig.axis).norm(), imperfection * rig.length);
        EXPECT_LE(rig.needle->state().deflection, imperfection * rig.length);
        EXPECT_FALSE(rig.needle->state().buckled);
        EXPECT_GT(rig.needle->state().critical_load, 0.0);
        EXPECT_EQ(rig.needle->beyond_validity(), nullptr);
    });
}

void hand_feels_what_was_committed(const Descriptor& plugin, const Case& with) {
    at_both_depths(plugin, with, [](Rig& rig) {
        ASSERT_TRUE(rig.advance(0.5 * rig.load));
        const Wrench wrench = rig.needle->base_wrench();
        const NeedleState state = rig.needle->state();
        rig.predict();
        (void)rig.converge(rig.load);
        EXPECT_EQ(rig.needle->base_wrench().force, wrench.force);
        EXPECT_EQ(rig.needle->base_wrench().moment, wrench.moment);
        EXPECT_EQ(rig.needle->state().axial_load, state.axial_load);
        EXPECT_EQ(rig.needle->state().deflection, state.deflection);
    });
}

double total(const EnergyReport& energy) {
    return energy.stored + energy.kinetic + energy.damping + energy.numerical;
}

/// The hand pushes after the tip, so that the tip hardly gets further along the needle: most energy comes through the base.
void energy_comes_through_the_base(const Descriptor& plugin, const Case& with) {
    at_both_depths(plugin, with, [&with](Rig& rig) {
        const double start = total(rig.body->energy());
        VectorX forces = VectorX::Zero(rig.load.size());
        VectorX places = rig.positions(forces);
        const Vector3 tip = places.tail<3>();
        Vector3 hand = rig.needle->base_wrench().force;
        double work = 0.0;     // [J]
        double bound = 0.0;    // [J] the work of a step lies between those of its two forces
        for (int i = 1; i <= with.steps; ++i) {
            const VectorX next = rig.load * (static_cast<double>(i) / with.steps);
            rig.predict();
            ASSERT_TRUE(rig.converge(next));
            const Vector3 push = rig.axis * rig.axis.dot(tip - rig.positions(next).tail<3>());
            rig.body->rollback();
            rig.base.position += push;
            ASSERT_TRUE(rig.advance(next));
            const VectorX moved = rig.positions(next) - places;
            const Vector3 held = rig.needle->base_wrench().force;
            work += 0.5 * (forces + next).dot(moved) + 0.5 * (hand + held).dot(push);
            bound += 0.5 * (next - forces).cwiseAbs().dot(moved.cwiseAbs()) + 0.5 * (held - hand).cwiseAbs().dot(push.cwiseAbs());
            places += moved;
            forces = next;
            hand = held;
        }
        const double rounded = with.steps * rig.load.lpNorm<1>() * position_tolerance(rig);    // [J]
        EXPECT_NEAR(total(rig.body->energy()) - start, work, bound + rounded);
    });
}

void entry_force_is_the_energy_of_free_length(const Descriptor& plugin, const Case& with) {
    constexpr double shrinks_to = 0.95;    // of the free length: little enough that a bowed needle stays bowed
    at_both_depths(plugin, with, [&with](Rig& rig) {
        ASSERT_TRUE(stand_still(rig));
        const double start = total(rig.body->energy());
        const double change = (shrinks_to - 1.0) * rig.free_length / with.steps;    // [m] of the free length in a step
        VectorX places = rig.positions(rig.load);
        double entry = rig.needle->entry_force();
        double work = 0.0;     // [J]
        double bound = 0.0;    // [J]
        for (int i = 0; i < with.steps; ++i) {
            rig.free_length += change;
            ASSERT_TRUE(rig.advance(rig.load));
            const VectorX moved = rig.positions(rig.load) - places;
            const double now = rig.needle->entry_force();
            work += rig.load.dot(moved) - 0.5 * (entry + now) * change;
            bound += 0.5 * std::abs((now - entry) * change);
            places += moved;
            entry = now;
        }
        const double rounded = with.steps * rig.load.lpNorm<1>() * position_tolerance(rig);    // [J]
        EXPECT_NEAR(total(rig.body->energy()) - start, work, bound + rounded);
    });
}

/// Core tells the free length that a step has led to just before the commit.
void a_free_length_told_at_once_moves_nothing(const Descriptor& plugin, const Case& with) {
    at_both_depths(plugin, with, [](Rig& rig) {
        rig.predict();
        ASSERT_TRUE(rig.converge(rig.load));
        const auto places = [&rig] {
            std::vector<double> all;
            for (const ContactPoint& point : rig.points) {
                const Vector3 place = rig.needle->held_position(point.arclength);
                all.insert(all.end(), place.begin(), place.end());
            }
            return all;
        };
        const std::vector<double> before = places();
        rig.needle->predict(rig.base, 0.99 * rig.free_length, 0.0);
        EXPECT_TRUE(same_bits(before, places()));
        rig.body->commit();
        EXPECT_TRUE(same_bits(before, places()));
        EXPECT_TRUE(all_finite(answers(rig)));
    });
}

void any_free_length_gives_finite_answers(const Descriptor& plugin, const Case& with) {
    for (const double free_length : {0.0, 1e-300, 1e-12, with.needle.radius, with.needle.length}) {
        SCOPED_TRACE("a free length of " + std::to_string(1e3 * free_length) + " mm");
        Rig rig = make_rig(plugin, with, 0.0, 5e-3);
        rig.free_length = free_length;
        (void)rig.advance(rig.load);
        EXPECT_TRUE(all_finite(answers(rig)));
    }
}

}    // namespace

std::vector<Check> needle_checks() {
    std::vector<Check> checks = body_checks();
    checks.insert(checks.end(), {{"MovesRigidlyWithItsBase", moves_rigidly_with_its_base},
                                 {"BaseBalancesTheContacts", base_balances_the_contacts},
                                 {"HandFeelsWhatWasCommitted", hand_feels_what_was_committed},
                                 {"PlacesAgree", places_agree},
                                 {"UnloadedItIsStraight", unloaded_it_is_straight},
                                 {"EnergyComesThroughTheBase", energy_comes_through_the_base},
                                 {"EntryForceIsTheEnergyOfFreeLength", entry_force_is_the_energy_of_free_length},
                                 {"AFreeLengthToldAtOnceMovesNothing", a_free_length_told_at_once_moves_nothing},
                                 {"AnyFreeLengthGivesFiniteAnswers", any_free_length_gives_finite_answers}});
    return checks;
}

}    // namespace stylet::contract
