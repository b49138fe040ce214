// What needle and tissue promise alike.
#include "checks.h"
#include "rig.h"

#include <stylet/contract/allocations.h>

#include <cmath>
#include <numbers>

namespace stylet::contract {
namespace {

constexpr double symmetry = 1e-12;              // of the largest compliance: a few hundred roundings of a factorised solve
constexpr double residual = 1e-9;               // [N] what Rig::converge leaves
constexpr double difference_rounding = 1e-6;    // of the largest compliance: rounding of a central difference over `nudge`
constexpr double nudge = 1e-3;                  // of the load: far above the residual, far below what bends a compliance
constexpr double rounding = 1e-10;              // of the sum of magnitudes: 64 steps of trapezoids on an exactly linear body

/// A smooth path of forces from none to the whole load on which the components don't rise together.
VectorX path(const Rig& rig, double t) {
    VectorX forces = rig.load;
    for (Eigen::Index j = 0; j < forces.size(); ++j) {
        const double phase = static_cast<double>(j);
        forces[j] *= t + 0.1 * (std::sin(2.0 * std::numbers::pi * t + phase) - std::sin(phase));
    }
    return forces;
}

void compliance_is_symmetric(const Descriptor& plugin, const Case& with) {
    at_both_depths(plugin, with, [](Rig& rig) {
        ASSERT_TRUE(rig.advance(rig.load)) << "does not come into balance under the case's load";
        const MatrixX w = rig.body->linearise(rig.points, 0.0).compliance;
        EXPECT_LE((w - w.transpose()).cwiseAbs().maxCoeff(), symmetry * w.cwiseAbs().maxCoeff());
    });
}

/// Where the contacts are: a needle says so by itself, a tissue through its linearisation only.
VectorX seen_places(const Rig& rig, const VectorX& forces) {
    if (rig.needle == nullptr) return rig.positions(forces);
    VectorX places(forces.size());
    for (std::size_t i = 0; i < rig.points.size(); ++i)
        places.segment<3>(3 * i) = rig.needle->held_position(rig.points[i].arclength);
    return places;
}

void contacts_move_as_the_compliance_says(const Descriptor& plugin, const Case& with) {
    at_both_depths(plugin, with, [&with](Rig& rig) {
        ASSERT_TRUE(rig.advance(rig.load));
        const auto answer = [&rig](const VectorX& forces) {
            rig.body->rollback();
            rig.predict();
            EXPECT_TRUE(rig.converge(forces));
            return seen_places(rig, forces);
        };
        const VectorX here = answer(rig.load);
        const MatrixX w = rig.body->linearise(rig.points, 0.0).compliance;
        const double step = nudge * rig.load.cwiseAbs().maxCoeff();
        for (Eigen::Index j = 0; j < rig.load.size(); ++j) {
            const VectorX unit = VectorX::Unit(rig.load.size(), j);
            const auto slope = [&](double h) -> VectorX {
                return (answer(rig.load + h * unit) - answer(rig.load - h * unit)) / (2.0 * h);
            };
            const VectorX coarse = slope(step);
            const VectorX fine = slope(0.5 * step);
            // Richardson: the fine slope is off by a third of what the two differ, and by what the residuals and rounding leave.
            const double tolerance = (coarse - fine).cwiseAbs().maxCoeff() +
                                     w.cwiseAbs().maxCoeff() * (with.tangent + difference_rounding + residual / step) +
                                     8.0 * std::numeric_limits<double>::epsilon() * here.cwiseAbs().maxCoeff() / step;
            EXPECT_LE((fine - w.col(j)).cwiseAbs().maxCoeff(), tolerance) << "force " << j;
        }
    });
}

void linearise_is_repeatable(const Descriptor& plugin, const Case& with) {
    at_both_depths(plugin, with, [](Rig& rig) {
        ASSERT_TRUE(rig.advance(0.7 * rig.load));
        rig.predict();
        ASSERT_TRUE(rig.converge(rig.load));
        const std::vector<double> first = answers(rig);
        EXPECT_TRUE(same_bits(first, answers(rig)));
        rig.body->commit();
        const EnergyReport before = rig.body->energy();
        (void)rig.body->linearise(rig.points, 0.0);
        EXPECT_EQ(before.stored, rig.body->energy().stored) << "linearise committed something";
    });
}

void rollback_restores_every_bit(const Descriptor& plugin, const Case& with) {
    at_both_depths(plugin, with, [](Rig& rig) {
        ASSERT_TRUE(rig.advance(rig.load));
        const std::vector<double> committed = answers(rig);
        const Pose base = rig.base;
        rig.base.position += Vector3(1e-3, -2e-3, 3e-3);
        rig.free_length *= 0.9;
        rig.predict();
        (void)rig.converge(1.3 * rig.load);
        if (rig.needle != nullptr) {
            EXPECT_FALSE(same_bits(committed, answers(rig))) << "the trial changed nothing";
        }
        rig.base = base;
        rig.body->rollback();
        EXPECT_TRUE(same_bits(committed, answers(rig)));
    });
}

void same_calls_give_the_same_bits(const Descriptor& plugin, const Case& with) {
    std::vector<std::vector<double>> runs;
    for (int run = 0; run < 2; ++run) {
        std::vector<double> all;
        at_both_depths(plugin, with, [&all](Rig& rig) {
            for (int i = 1; i <= 8; ++i) {
                EXPECT_TRUE(rig.advance(path(rig, i / 8.0)));
                const std::vector<double> more = answers(rig);
                all.insert(all.end(), more.begin(), more.end());
            }
        });
        runs.push_back(std::move(all));
    }
    EXPECT_TRUE(same_bits(runs[0], runs[1]));
}

double total(const EnergyReport& energy) {
    return energy.stored + energy.kinetic + energy.damping + energy.numerical;
}

void energy_is_the_work_of_the_forces(const Descriptor& plugin, const Case& with) {
    at_both_depths(plugin, with, [&with](Rig& rig) {
        const MatrixX at_rest = rig.body->linearise(rig.points, 0.0).compliance;
        const double start = total(rig.body->energy());
        VectorX forces = VectorX::Zero(rig.load.size());
        VectorX places = rig.positions(forces);
        double work = 0.0;         // [J] ½ Σ (fₙ + fₙ₊₁)·Δu
        double magnitude = 0.0;    // [J] Σ |f·Δu|
        double bound = 0.0;        // [J] ½ Σ |Δf·Δu|: the work of a step lies between those of its two forces
        bool massless = true;
        for (int i = 1; i <= with.steps; ++i) {
            const VectorX next = path(rig, static_cast<double>(i) / with.steps);
            ASSERT_TRUE(rig.advance(next)) << "step " << i;
            const VectorX moved = rig.positions(next) - places;
            work += 0.5 * (forces + next).dot(moved);
            magnitude += next.cwiseAbs().dot(moved.cwiseAbs());
            bound += 0.5 * (next - forces).cwiseAbs().dot(moved.cwiseAbs());
            places += moved;
            forces = next;
            massless = massless && rig.body->energy().kinetic == 0.0;
        }
        const MatrixX loaded = rig.body->linearise(rig.points, 0.0).compliance;
        const bool linear = massless && with.tangent == 0.0 &&
                            (loaded - at_rest).cwiseAbs().maxCoeff() <= symmetry * loaded.cwiseAbs().maxCoeff();
        const double tolerance = rounding * magnitude + (linear ? 0.0 : bound);
        EXPECT_NEAR(total(rig.body->energy()) - start, work, tolerance) << (linear ? "a linear body" : "a nonlinear body");
    });
}

void lost_energy_never_comes_back(const Descriptor& plugin, const Case& with) {
    at_both_depths(plugin, with, [](Rig& rig) {
        EnergyReport most = rig.body->energy();    // of each entry so far
        for (int i = 1; i <= 40; ++i) {
            ASSERT_TRUE(rig.advance(std::sin(std::numbers::pi * i / 10.0) * rig.load));
            const EnergyReport now = rig.body->energy();
            most.kinetic = std::max(most.kinetic, now.kinetic);
            // The trapezoid's share of a vibration swings by half a time step's turn of it: less than what swings.
            EXPECT_GE(now.damping, most.damping - most.kinetic) << "tick " << i;
            EXPECT_GE(now.numerical, most.numerical - most.kinetic) << "tick " << i;
            most.damping = std::max(most.damping, now.damping);
            most.numerical = std::max(most.numerical, now.numerical);
        }
    });
}

void extreme_forces_give_finite_answers(const Descriptor& plugin, const Case& with) {
    for (const double scale : {0.0, 1e-300, 1e-12, 1e6}) {
        SCOPED_TRACE("the load times " + std::to_string(scale));
        at_both_depths(plugin, with, [scale](Rig& rig) {
            (void)rig.advance(scale * rig.load);
            EXPECT_TRUE(all_finite(answers(rig)));
            (void)rig.advance(-scale * rig.load);
            EXPECT_TRUE(all_finite(answers(rig)));
        });
    }
}

void takes_no_contacts_at_all(const Descriptor& plugin, const Case& with) {
    at_both_depths(plugin, with, [](Rig& rig) {
        rig.points.clear();
        EXPECT_TRUE(rig.advance(VectorX()));
        EXPECT_TRUE(all_finite(answers(rig)));
    });
}

/// A coupling that halves its step compares the energies of trials, and the books read the same after the commit.
void energy_is_that_of_the_latest_trial(const Descriptor& plugin, const Case& with) {
    at_both_depths(plugin, with, [](Rig& rig) {
        ASSERT_TRUE(rig.advance(0.5 * rig.load));
        const auto reported = [&rig] {
            const EnergyReport energy = rig.body->energy();
            return std::vector{energy.stored, energy.kinetic, energy.damping, energy.numerical};
        };
        rig.predict();
        ASSERT_TRUE(rig.converge(rig.load));
        const std::vector<double> tried = reported();
        rig.body->commit();
        EXPECT_TRUE(same_bits(tried, reported()));
    });
}

/// One tick and everything that core asks in it.
void ask_everything(const Rig& rig, ContactPoints points, Forces forces, std::span<Vector3> line) {
    rig.predict();
    for (int i = 0; i < 2; ++i) {
        (void)rig.body->linearise(points, 0.0);
        (void)rig.body->try_step(points, forces);
    }
    rig.body->commit();
    (void)rig.body->energy();
    if (rig.tissue != nullptr) {
        (void)rig.tissue->locate(points.front().material);
        (void)rig.tissue->entry(Vector3(0.0, 0.0, 1e-3), Vector3(0.0, 0.0, -1e-3));
        (void)rig.tissue->beyond_validity();
    }
    if (rig.needle != nullptr) {
        (void)rig.needle->position(rig.length);
        (void)rig.needle->tangent(rig.length);
        (void)rig.needle->entry_force();
        (void)rig.needle->base_wrench();
        (void)rig.needle->state();
        rig.needle->centreline(line);
        (void)rig.needle->beyond_validity();
    }
    rig.predict();
    (void)rig.body->linearise(points, 0.0);
    (void)rig.body->try_step(points, forces);
    rig.body->rollback();
}

void a_tick_allocates_nothing(const Descriptor& plugin, const Case& with) {
    const Rig rig = make_rig(plugin, with, with.depth, with.depth / (max_contacts - 1));
    ASSERT_EQ(rig.points.size(), static_cast<std::size_t>(max_contacts));
    std::vector<Vector3> line(33);
    const std::size_t before = allocations();
    for (const std::size_t count : {std::size_t{1}, std::size_t{7}, std::size_t{max_contacts}}) {
        const ContactPoints points(rig.points.data(), count);
        ask_everything(rig, points, Forces(rig.load.data(), static_cast<Eigen::Index>(3 * count)), line);
    }
    EXPECT_EQ(allocations() - before, 0U) << "from its making on, up to max_contacts contacts";
}

}    // namespace

std::vector<Check> body_checks() {
    return {{"ComplianceIsSymmetric", compliance_is_symmetric},
            {"ContactsMoveAsTheComplianceSays", contacts_move_as_the_compliance_says},
            {"LineariseIsRepeatable", linearise_is_repeatable},
            {"RollbackRestoresEveryBit", rollback_restores_every_bit},
            {"EnergyIsThatOfTheLatestTrial", energy_is_that_of_the_latest_trial},
            {"SameCallsGiveTheSameBits", same_calls_give_the_same_bits},
            {"EnergyIsTheWorkOfTheForces", energy_is_the_work_of_the_forces},
            {"LostEnergyNeverComesBack", lost_energy_never_comes_back},
            {"ExtremeForcesGiveFiniteAnswers", extreme_forces_give_finite_answers},
            {"TakesNoContactsAtAll", takes_no_contacts_at_all},
            {"ATickAllocatesNothing", a_tick_allocates_nothing}};
}

}    // namespace stylet::contract
