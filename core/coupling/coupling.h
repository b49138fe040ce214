#pragma once

#include <stylet/needle_model.h>
#include <stylet/tissue_model.h>

#include "core/contacts/contact_set.h"
#include "core/coupling/box_problem.h"

namespace stylet::core {

/// How a solve ended. Where `converged` is false the bodies hold an unfinished trial state: roll them back.
struct CouplingReport {
    bool converged = false;
    int linearisations = 0;
    double residual = 0.0;     // [N]
    bool held_back = false;    // the tip or the mouth would have gone further than allowed
};

/// Brings needle and tissue together: finds the contact forces λ of one step.
///
///     v = (W_needle + W_tissue) λ + free_needle − free_tissue      in the needle's frame, each contact
///
/// Lateral rows are bilateral (v = 0), axial rows stick inside their box and slip at its sides (BoxProblem). Both bodies are
/// linearised about their trial state, solved, stepped, and linearised again until no force is out of balance by more than
/// `tolerance`. The branch is checked by inertia: the block of the rows that hold (lateral ones, and axial ones inside their box)
/// must have as many negative pivots as the bodies report (Haynsworth 1968); while it has not, the bodies are linearised with a
/// growing shift τ M.
///
/// Two configurational forces act along the needle whatever its motion, both taken from the step's start, because a step changes
/// them little. The mouth of the track pushes a bowed needle out (NeedleModel::entry_force). And a tip that is pressed sideways
/// pushes into a track that lies askew: by how much follows from the energy that moving the sideways forces along with the tip
/// has just given them, over its way. Without it a sideways push, an insertion, and the way back would give the hand energy.
///
/// Changes the bodies' trial state only; allocates nothing.
class Coupling {
public:
    static constexpr double tolerance = 1e-9;         // [N]
    static constexpr int most_linearisations = 16;    // Newton needs 2, a change of branch a few more

    Coupling();

    /// Moves the old forces to the new contact points, before the tissue is predicted: a step of the tissue at the same instant,
    /// whatever it is made of. Returns by how much that changed its stored energy [J].
    double carry(TissueModel& tissue, ContactSet& contacts);

    /// `most_advance` [m] bounds the tip's way past the tissue in one solve, and a bowed needle's forward and back, at the mouth
    /// eight times that.
    CouplingReport solve(NeedleModel& needle, TissueModel& tissue, ContactSet& contacts, Mouth mouth, double most_advance,
                         double dt);

    /// The caller has committed the bodies.
    void commit() {
        committed_ = trial_;
        old_points_.assign(points_.begin(), points_.end());
    }

private:
    struct Views {
        Linearisation needle, tissue;
    };
    /// What the next step must know of this one.
    struct Memory {
        double askew = 0.0;     // [N] configurational force on the tip
        double gained = 0.0;    // [J] not yet part of `askew`, and over which way [m]
        double way = 0.0;
    };
    bool solve_linearised(NeedleModel& needle, TissueModel& tissue, ContactSet& contacts, Mouth mouth, double most_advance,
                          double dt, CouplingReport& report);
    [[nodiscard]] double largest_force() const;    // [N] of the last box problem
    void number_rows(const ContactSet& contacts);
    void assemble(const Views& bodies, const ContactSet& contacts);
    void add_own_forces(const Views& bodies, const ContactSet& contacts);
    BoxProblem::Outcome solve_box(ContactSet& contacts, Mouth mouth, double most_advance);
    BoxProblem::Outcome attempt(const ContactSet& contacts, double most_advance);
    bool reconsider(ContactRow& row, int along, double most_forward, double most_back, bool& may_hold);
    void hand_out(ContactSet& contacts);
    bool take_up(const ContactSet& contacts);
    bool restep(TissueModel& tissue, ContactSet& contacts, double& axial);
    void note_where_carried(const Linearisation& tissue, ContactSet& contacts);
    static double seeming_work(const ContactSet& contacts);
    void note_askew_force(const ContactRow& row);
    double energy_of(const Linearisation& tissue, const VectorX& forces);
    void take_stock(const Linearisation& tissue, ContactSet& contacts);
    [[nodiscard]] int axial_row(int contact) const { return bilateral_ + contact; }

    BoxProblem box_;
    int bilateral_ = 0;    // number of lateral rows; axial rows follow, one for each contact
    int rows_ = 0;
    std::vector<int> lateral_row_;      // of each contact its first lateral row, or −1
    MatrixX compliance_, work_;         // rows × rows, [m/N]
    VectorX free_, right_;              // rows, [m]
    VectorX lower_, upper_, lambda_;    // rows, [N]
    VectorX forces_, opposite_;         // 3n on the needle and on the tissue, world, [N]
    VectorX own_;                       // 3n on the needle whatever the motion, world, [N]
    VectorX axial_;                     // 3n, what of the old forces is along the needle, [N]
    VectorX scratch_;                   // 3n, [m]
    double shift_ = 0.0;                // [1/s²] τ of this solve
    Memory trial_, committed_;
    std::vector<ContactPoint> points_, old_points_;    // of the last solve, and of the last commit
};

}    // namespace stylet::core
