#include "core/ledger/ledger.h"

#include <algorithm>
#include <cmath>

namespace stylet::core {

namespace {

double hand_work(const HandStep& hand) {
    const Vector3 moved = hand.after.position - hand.before.position;
    const Eigen::AngleAxisd turned(hand.after.rotation * hand.before.rotation.conjugate());
    return 0.5 * (hand.wrench_before.force + hand.wrench_after.force).dot(moved) +
           0.5 * (hand.wrench_before.moment + hand.wrench_after.moment).dot(turned.angle() * turned.axis());
}

// The trapezoid's force over the step, in the row's frame.
Vector3 mean(const ContactRow& row, const Vector3& old_force, const Vector3& force) {
    return 0.5 * (row.frame.transpose() * (old_force + force));
}

double slip_work(const ContactRow& row) {
    return mean(row, row.old_effect_force, row.effect_force).z() * row.advance;
}

// See the header. A contact that let go of its track in this step still has half its old force to work with while it springs
// aside; a tip that lies askew pays for what its sideways forces gain by moving on.
double released(const ContactSet& contacts, double relocation) {
    double work = -relocation;
    if (contacts.in_air) return work;
    for (std::size_t i = 0; i < contacts.rows.size(); ++i) {
        const ContactRow& row = contacts.rows[i];
        work -= mean(row, row.old_force, row.force).dot(row.carried_over);
        work -= mean(row, row.old_effect_force, row.effect_force).head<2>().dot(row.offset.head<2>());
        if (contacts.points[i].tip) work += 0.5 * (row.old_configurational + row.configurational) * row.advance;
    }
    return work;
}

// Of what pushes the tip of a needle that is alone: all it moves is against that. Where it is held, its way is rounding.
double end_work(const ContactSet& contacts) {
    if (!contacts.in_air) return 0.0;
    const ContactRow& tip = contacts.rows.front();
    const Vector3 force = mean(tip, tip.old_effect_force, tip.effect_force);
    const bool held = tip.upper > 0.0;
    return (tip.lateral ? 0.0 : force.head<2>().dot(tip.offset.head<2>())) + (held ? 0.0 : force.z() * tip.offset.z());
}

EnergyReport both(const NeedleModel& needle, const TissueModel& tissue) {
    const EnergyReport n = needle.energy(), t = tissue.energy();
    return {.stored = n.stored + t.stored,
            .kinetic = n.kinetic + t.kinetic,
            .damping = n.damping + t.damping,
            .numerical = n.numerical + t.numerical};
}

}    // namespace

void Ledger::open(const NeedleModel& needle, const TissueModel& tissue) {
    opening_ = both(needle, tissue);
    balance_ = {};
    peak_work_ = std::abs(opening_.stored);    // what there is to lose
    peak_residual_ = 0.0;
}

EnergyReport Ledger::since_opening(const NeedleModel& needle, const TissueModel& tissue) const {
    const EnergyReport now = both(needle, tissue);
    return {.stored = now.stored - opening_.stored,
            .kinetic = now.kinetic - opening_.kinetic,
            .damping = now.damping - opening_.damping,
            .numerical = now.numerical - opening_.numerical};
}

void Ledger::close(const HandStep& hand, const ContactSet& contacts, const StepCosts& costs, const NeedleModel& needle,
                   const TissueModel& tissue) {
    balance_.hand_work += hand_work(hand);
    balance_.load_work += costs.loads + end_work(contacts);
    for (std::size_t i = 0; i < contacts.rows.size() && !contacts.in_air; ++i) {
        const double work = slip_work(contacts.rows[i]);
        const double surplus = 0.5 * (contacts.rows[i].old_excess + contacts.rows[i].excess) * contacts.rows[i].advance;
        balance_.burst += contacts.points[i].tip ? work : surplus;
        if (!contacts.points[i].tip) balance_.friction += work - surplus;
    }
    balance_.burst -= costs.fracture;
    balance_.fracture += costs.fracture;
    balance_.released += released(contacts, costs.relocation);
    const EnergyReport now = since_opening(needle, tissue);
    balance_.stored = now.stored;
    balance_.kinetic = now.kinetic;
    balance_.damping = now.damping;
    balance_.numerical = now.numerical;
    peak_work_ = std::max({peak_work_, std::abs(balance_.hand_work + balance_.load_work), std::abs(balance_.stored)});
    peak_residual_ = std::max(peak_residual_, std::abs(balance_.residual()));
}

double Ledger::imbalance_at_rest(const ContactSet& contacts, const StepCosts& costs, const NeedleModel& needle,
                                 const TissueModel& tissue) const {
    const EnergyReport now = since_opening(needle, tissue);
    double change = now.stored + now.kinetic + now.damping + now.numerical -
                    (balance_.stored + balance_.kinetic + balance_.damping + balance_.numerical);
    if (!contacts.in_air) {
        for (const ContactRow& row : contacts.rows) change += slip_work(row);
    }
    return costs.loads + end_work(contacts) - (change + released(contacts, costs.relocation));
}

}    // namespace stylet::core
