#pragma once

#include <stylet/needle_model.h>
#include <stylet/tissue_model.h>

#include "core/contacts/contact_set.h"

namespace stylet::core {

/// Every energy of a run [J], since its start.
struct Balance {
    double hand_work = 0.0;
    double load_work = 0.0;    // of prescribed loads on the tissue's surface or the needle's end
    double stored = 0.0;       // elastic, of both bodies
    double kinetic = 0.0;
    double fracture = 0.0;    // what the effects say that cutting consumed
    double friction = 0.0;    // axial slip along the shaft
    double burst = 0.0;       // what a rupture has too much: work at the tip beyond cutting, and of holding the mouth back
    double released = 0.0;    // by contact points that moved on in the tissue
    double damping = 0.0;
    double numerical = 0.0;

    [[nodiscard]] double accounted() const {
        return stored + kinetic + fracture + friction + burst + released + damping + numerical;
    }
    [[nodiscard]] double residual() const { return hand_work + load_work - accounted(); }
};

/// What a step cost beside what bodies and contacts tell.
struct StepCosts {
    double loads = 0.0;         // [J] work of loads on the tissue's surface
    double relocation = 0.0;    // [J] by which moving the old forces to the new contact points changed the tissue's energy, less
                                // the work of loads on the way
    double fracture = 0.0;      // [J] what the effects say that cutting consumed
};

/// One step of the hand.
struct HandStep {
    Pose before, after;
    Wrench wrench_before, wrench_after;    // on the needle, about its base
};

/// Closes the books by the trapezoid rule: exact for linear bodies, second order for others.
///
///     hand work + load work = Δ(stored + kinetic) + fracture + friction + burst + released + damping + numerical + residual
///
/// Paper's Eq. (7) is this balance solved for the force. A step's slip w does the work ½(λₙ + λₙ₊₁) w; at the tip what exceeds
/// fracture is burst. `released` is what moving a contact's point through the tissue frees: −ΔE − Σ ½(fₙ + fₙ₊₁)·(carried over),
/// less what the tip's configurational force has paid for, and what a contact gives up sideways when it lets go. It also takes
/// back what a growing piece of shaft counts as slip too much, because its middle moves: there it is negative. Friction alone
/// depends on the contact spacing by that much; the two together hardly do.
class Ledger {
public:
    /// Opens the books: whatever the bodies store now (a tip that begins in the tissue) is where the balance starts from.
    void open(const NeedleModel& needle, const TissueModel& tissue);

    /// Takes a committed step.
    void close(const HandStep& hand, const ContactSet& contacts, const StepCosts& costs, const NeedleModel& needle,
               const TissueModel& tissue);

    /// What a trial step at rest of the hand would leave unaccounted for [J]; commits nothing.
    [[nodiscard]] double imbalance_at_rest(const ContactSet& contacts, const StepCosts& costs, const NeedleModel& needle,
                                           const TissueModel& tissue) const;

    [[nodiscard]] const Balance& balance() const { return balance_; }
    [[nodiscard]] double peak_work() const { return peak_work_; }            // [J] largest |hand + load work|, or stored, so far
    [[nodiscard]] double peak_residual() const { return peak_residual_; }    // [J] largest |residual| so far

private:
    [[nodiscard]] EnergyReport since_opening(const NeedleModel& needle, const TissueModel& tissue) const;

    EnergyReport opening_;    // [J] of both bodies when the books were opened
    Balance balance_;
    double peak_work_ = 0.0;
    double peak_residual_ = 0.0;
};

}    // namespace stylet::core
