#include "core/coupling/coupling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stylet::core {

namespace {

constexpr int tip = 0;
constexpr int axial = 2;    // the frame's third column
constexpr double infinity = std::numeric_limits<double>::infinity();
// From a quarter of the inertia's own 1/dt², by factors of two: the closer a shift is to the least that it takes, the further the
// step leaves an unstable branch.
constexpr double first_shift = 0.25;
constexpr double shift_growth = 2.0;
// Of the largest force. A needle past its limit load that its tissue holds is stable where its boxed rows are not convex. Far
// from balance Newton takes convex steps all the same.
constexpr double nearly_balanced = 3e-2;
constexpr int most_shifts = 32;    // 2³²/(4 dt²): far stiffer than any needle

// Surface that springs up along a needle moves further than its tip: so much further the mouth may go in one solve.
constexpr double mouth_share = 8.0;

constexpr int most_rows = 3 * max_contacts;

Vector3 sideways_of(const ContactRow& row, const Vector3& force) {
    const Vector3 along = row.frame.col(axial);
    return force - force.dot(along) * along;
}

}    // namespace

Coupling::Coupling()
    : box_(most_rows),
      lateral_row_(max_contacts),
      compliance_(MatrixX::Zero(most_rows, most_rows)),
      work_(MatrixX::Zero(most_rows, most_rows)),
      free_(VectorX::Zero(most_rows)),
      right_(VectorX::Zero(most_rows)),
      lower_(VectorX::Zero(most_rows)),
      upper_(VectorX::Zero(most_rows)),
      lambda_(VectorX::Zero(most_rows)),
      forces_(VectorX::Zero(most_rows)),
      opposite_(VectorX::Zero(most_rows)),
      own_(VectorX::Zero(most_rows)),
      axial_(VectorX::Zero(most_rows)),
      scratch_(VectorX::Zero(most_rows)) {
    points_.reserve(max_contacts);
    old_points_.reserve(max_contacts);
}

CouplingReport Coupling::solve(NeedleModel& needle, TissueModel& tissue, ContactSet& contacts, Mouth mouth, double most_advance,
                               double dt) {
    CouplingReport report;
    const auto count = static_cast<Eigen::Index>(contacts.points.size());
    const Forces on_needle(forces_.data(), 3 * count), on_tissue(opposite_.data(), 3 * count);
    number_rows(contacts);
    points_.assign(contacts.points.begin(), contacts.points.end());
    for (ContactRow& row : contacts.rows) row.configurational = 0.0;
    if (mouth.row >= 0) contacts.rows[mouth.row].configurational = mouth.grip * needle.entry_force();
    if (!contacts.empty() && contacts.rows[tip].lateral) contacts.rows[tip].configurational += trial_.askew;
    while (!report.converged && report.linearisations < most_linearisations) {
        if (!solve_linearised(needle, tissue, contacts, mouth, most_advance, dt, report)) break;
        const StepReport needle_step = needle.try_step(contacts.points, on_needle);
        const StepReport tissue_step = tissue.try_step(contacts.points, on_tissue);
        report.residual = std::max(needle_step.residual, tissue_step.residual);
        const bool balanced = needle_step.residual <= tolerance && tissue_step.residual <= tolerance;    // false for NaN
        // A shift was needed: the state before the step was unstable, and nothing says that the one after it is not.
        report.converged = balanced && shift_ == 0.0 && !needle_step.tangent_changed && !tissue_step.tangent_changed;
    }
    for (std::size_t i = 0; i < contacts.rows.size(); ++i) {
        ContactRow& row = contacts.rows[i];
        report.held_back = report.held_back || row.held != 0;
        row.offset = row.frame.transpose() * (needle.held_position(contacts.points[i].arclength) - row.tissue_position);
    }
    return report;
}

// Linearises both bodies and solves their rows, with as much shift as it takes to be on a stable branch.
bool Coupling::solve_linearised(NeedleModel& needle, TissueModel& tissue, ContactSet& contacts, Mouth mouth, double most_advance,
                                double dt, CouplingReport& report) {
    shift_ = 0.0;    // anew each time: once on a stable branch, Newton's full step converges in a few
    for (int shifts = 0; shifts <= most_shifts; ++shifts) {
        const Views bodies{needle.linearise(contacts.points, shift_), tissue.linearise(contacts.points, shift_)};
        assemble(bodies, contacts);
        const BoxProblem::Outcome box = solve_box(contacts, mouth, most_advance);
        const bool stable = box.solved && box.negatives == bodies.needle.negatives + bodies.tissue.negatives;
        // Before the first step nothing is known to be out of balance: a tick begins where the last one was balanced.
        const bool close = report.residual <= nearly_balanced * largest_force();
        if (stable && (box.convex || close)) {
            ++report.linearisations;
            hand_out(contacts);
            take_stock(bodies.tissue, contacts);
            return true;
        }
        if (!(dt > 0.0)) return false;    // no time has passed: no inertia to lean on
        shift_ = shift_ == 0.0 ? first_shift / (dt * dt) : shift_ * shift_growth;
    }
    return false;
}

double Coupling::largest_force() const {
    return rows_ > 0 ? lambda_.head(rows_).cwiseAbs().maxCoeff() : 0.0;
}

// Lateral rows first: they are eliminated before the boxes are looked at.
void Coupling::number_rows(const ContactSet& contacts) {
    bilateral_ = 0;
    const auto count = static_cast<int>(contacts.points.size());
    for (int i = 0; i < count; ++i) {
        lateral_row_[i] = contacts.rows[i].lateral ? bilateral_ : -1;
        if (contacts.rows[i].lateral) bilateral_ += 2;
    }
    rows_ = bilateral_ + count;
}

// A = Dᵀ (W_needle + W_tissue) D, lower triangle, and b = Dᵀ (free_needle − free_tissue) + gap.
void Coupling::assemble(const Views& bodies, const ContactSet& contacts) {
    const auto count = static_cast<int>(contacts.points.size());
    for (int i = 0; i < count; ++i) {
        const ContactRow& row = contacts.rows[i];
        const int lateral = lateral_row_[i];
        const Vector3 between =
            row.frame.transpose() * (bodies.needle.free.segment<3>(3 * i) - bodies.tissue.free.segment<3>(3 * i) - row.beside);
        if (lateral >= 0) free_.segment<2>(lateral) = between.head<2>();
        free_[axial_row(i)] = between[axial] + row.gap;
        for (int j = 0; j <= i; ++j) {
            const Matrix3 both =
                bodies.needle.compliance.block<3, 3>(3 * i, 3 * j) + bodies.tissue.compliance.block<3, 3>(3 * i, 3 * j);
            const Matrix3 local = row.frame.transpose() * both * contacts.rows[j].frame;
            const int lateral_j = lateral_row_[j];
            compliance_(axial_row(i), axial_row(j)) = local(axial, axial);
            if (lateral_j >= 0) compliance_.block<1, 2>(axial_row(i), lateral_j) = local.block<1, 2>(axial, 0);
            if (lateral >= 0) compliance_.block<1, 2>(axial_row(j), lateral) = local.block<2, 1>(0, axial).transpose();
            if (lateral >= 0 && lateral_j >= 0) compliance_.block<2, 2>(lateral, lateral_j) = local.topLeftCorner<2, 2>();
        }
    }
    add_own_forces(bodies, contacts);
}

void Coupling::add_own_forces(const Views& bodies, const ContactSet& contacts) {
    const auto count = static_cast<Eigen::Index>(contacts.points.size());
    for (Eigen::Index i = 0; i < count; ++i) {
        const ContactRow& row = contacts.rows[i];
        own_.segment<3>(3 * i) = row.own_force + row.configurational * row.frame.col(axial);
    }
    const auto own = own_.head(3 * count);
    if (own.isZero(0.0)) return;
    auto moved = scratch_.head(3 * count);
    moved.noalias() = bodies.needle.compliance * own;
    moved.noalias() += bodies.tissue.compliance * own;
    for (int i = 0; i < count; ++i) {
        const Vector3 local = contacts.rows[i].frame.transpose() * moved.segment<3>(3 * i);
        if (lateral_row_[i] >= 0) free_.segment<2>(lateral_row_[i]) += local.head<2>();
        free_[axial_row(i)] += local[axial];
    }
}

// Solves the box problem; a tip or a mouth that runs further than it may in one solve is solved again with its way given and its
// force free, and let go again where that force turns out not to be needed.
BoxProblem::Outcome Coupling::solve_box(ContactSet& contacts, Mouth mouth, double most_advance) {
    constexpr int most_rounds = 6;    // two rows can each be held once and let go once
    for (ContactRow& row : contacts.rows) row.held = 0;
    bool may_hold[2] = {true, true};
    const bool bowed =
        mouth.row >= 0 && contacts.rows[mouth.row].configurational > 0.0;    // only a bow drives the mouth by itself
    BoxProblem::Outcome outcome;
    for (int round = 0; round < most_rounds; ++round) {
        outcome = attempt(contacts, most_advance);
        if (!outcome.solved || contacts.empty()) return outcome;
        const double back = bowed ? most_advance : infinity;    // only a bow throws a tip back
        const bool changed = reconsider(contacts.rows[tip], axial_row(tip), most_advance, back, may_hold[0]);
        const bool mouth_changed = bowed && reconsider(contacts.rows[mouth.row], axial_row(mouth.row), mouth_share * most_advance,
                                                       mouth_share * most_advance, may_hold[1]);
        if (!changed && !mouth_changed) return outcome;
    }
    return outcome;
}

BoxProblem::Outcome Coupling::attempt(const ContactSet& contacts, double most_advance) {
    auto work = work_.topLeftCorner(rows_, rows_);
    auto right = right_.head(rows_);
    auto lambda = lambda_.head(rows_);
    work.triangularView<Eigen::Lower>() = compliance_.topLeftCorner(rows_, rows_);
    right = free_.head(rows_);
    for (std::size_t i = 0; i < contacts.rows.size(); ++i) {
        const ContactRow& row = contacts.rows[i];
        const int along = axial_row(static_cast<int>(i));
        lower_[along] = row.held > 0 ? row.upper : row.held < 0 ? -infinity : row.lower;
        upper_[along] = row.held > 0 ? infinity : row.held < 0 ? row.lower : row.upper;
        if (row.held != 0) right[along] += row.held * (i == tip ? 1.0 : mouth_share) * most_advance - row.gap;
    }
    const BoxProblem::Outcome outcome = box_.solve(work, right, lower_.head(rows_), upper_.head(rows_), bilateral_, lambda);
    scratch_.head(rows_).noalias() = compliance_.topLeftCorner(rows_, rows_).selfadjointView<Eigen::Lower>() * lambda;
    return outcome;
}

// Returns whether the row's state changed. A row that was let go once is not held again in the same solve.
bool Coupling::reconsider(ContactRow& row, int along, double most_forward, double most_back, bool& may_hold) {
    const double advance = row.gap - (scratch_[along] + free_[along]);
    if (row.held == 0) {
        const double most = advance > 0.0 ? most_forward : most_back;
        if (!may_hold || std::abs(advance) <= most * (1.0 + 1e-9)) return false;
        const int way = advance > 0.0 ? 1 : -1;
        if (!std::isfinite(way > 0 ? row.upper : row.lower)) return false;
        row.held = way;
        return true;
    }
    const bool needed = row.held > 0 ? lambda_[along] > row.upper : lambda_[along] < row.lower;
    if (needed) return false;
    row.held = 0;
    may_hold = false;
    return true;
}

// λ → each contact's force and advance. A stuck contact advances by nothing at all: rounding must not creep.
void Coupling::hand_out(ContactSet& contacts) {
    for (std::size_t i = 0; i < contacts.rows.size(); ++i) {
        ContactRow& row = contacts.rows[i];
        const int along = axial_row(static_cast<int>(i)), across = lateral_row_[i];
        const auto at = 3 * static_cast<Eigen::Index>(i);
        const bool stuck = row.held == 0 && lambda_[along] > lower_[along] && lambda_[along] < upper_[along];
        row.axial_force = lambda_[along];
        row.advance = row.gap - (stuck ? 0.0 : scratch_[along] + free_[along]);
        row.excess = row.held == 0 ? 0.0 : lambda_[along] - (row.held > 0 ? row.upper : row.lower);
        Vector3 local(0.0, 0.0, lambda_[along]);
        if (across >= 0) local.head<2>() = lambda_.segment<2>(across);
        row.effect_force = row.frame * local + row.own_force;
        row.force = row.frame * local + own_.segment<3>(at);
        forces_.segment<3>(at) = row.force;
        opposite_.segment<3>(at) = -row.force;
    }
}

// Where contact points have moved, the old forces meet another tissue: the energy they gain and the advance they seem to make
// there belong to the move, not to the step. A body with inertia or a memory answers for it itself: at one instant nothing
// creeps, before the move as after it.
double Coupling::carry(TissueModel& tissue, ContactSet& contacts) {
    const double before = tissue.energy().stored;
    trial_ = committed_;
    if (contacts.empty()) trial_ = {};
    const bool sideways = take_up(contacts);
    tissue.predict(0.0);
    const double axial_before = sideways ? energy_of(tissue.linearise(old_points_, 0.0), axial_) : 0.0;
    double axial = 0.0;    // [J] after the move
    for (int i = 0; i < most_linearisations && !restep(tissue, contacts, axial); ++i) {
    }
    const double relocation = tissue.energy().stored - before;
    if (sideways) trial_.gained += relocation + axial - axial_before + seeming_work(contacts);
    if (!contacts.empty()) note_askew_force(contacts.rows[tip]);
    return relocation;
}

// The old forces; whether any of them is sideways.
bool Coupling::take_up(const ContactSet& contacts) {
    bool sideways = false;
    axial_.setZero();
    for (std::size_t i = 0; i < contacts.rows.size(); ++i) {
        const ContactRow& row = contacts.rows[i];
        const auto at = 3 * static_cast<Eigen::Index>(i);
        forces_.segment<3>(at) = row.old_force;
        opposite_.segment<3>(at) = -row.old_force;
        axial_.segment<3>(at) = row.old_force - row.old_sideways;
        sideways = sideways || !row.old_sideways.isZero(0.0);
    }
    return sideways;
}

// True once the tissue is in balance.
bool Coupling::restep(TissueModel& tissue, ContactSet& contacts, double& axial) {
    const auto rows = 3 * static_cast<Eigen::Index>(contacts.points.size());
    const Linearisation found = tissue.linearise(contacts.points, 0.0);
    note_where_carried(found, contacts);
    axial = energy_of(found, axial_);
    const StepReport report = tissue.try_step(contacts.points, Forces(opposite_.data(), rows));
    return report.residual <= tolerance && !report.tangent_changed;
}

void Coupling::note_where_carried(const Linearisation& tissue, ContactSet& contacts) {
    const auto count = static_cast<Eigen::Index>(contacts.rows.size());
    if (count == 0) return;
    auto moved = scratch_.head(3 * count);
    moved.noalias() = tissue.compliance.selfadjointView<Eigen::Lower>() * forces_.head(3 * count);
    for (Eigen::Index i = 0; i < count; ++i) {
        ContactRow& row = contacts.rows[i];
        const Vector3 misfit = row.old_position - (tissue.free.segment<3>(3 * i) - moved.segment<3>(3 * i));
        row.carried_over = -row.frame.transpose() * misfit;
        if (row.first_held) row.beside = sideways_of(row, misfit);
    }
}

// [J] By which the move seems to have driven the needle against the old forces.
double Coupling::seeming_work(const ContactSet& contacts) {
    double work = 0.0;
    for (const ContactRow& row : contacts.rows) work += row.old_force.dot(row.frame * row.carried_over + row.beside);
    return work;
}

// What moving along with the tip has given the old forces, over the tip's way. Short ways are added up: their quotient is
// rounding.
void Coupling::note_askew_force(const ContactRow& row) {
    constexpr double shortest_way = 1e-7;               // [m]
    const double steepest = row.old_sideways.norm();    // a track that lies askew by 45°
    trial_.way += row.old_advance;
    if (std::abs(trial_.way) >= shortest_way) {
        trial_.askew = trial_.gained / trial_.way;
        trial_.gained = 0.0;
        trial_.way = 0.0;
    }
    trial_.askew = std::clamp(trial_.askew, -steepest, steepest);
}

// ½ fᵀWf; leaves Wf in scratch_.
double Coupling::energy_of(const Linearisation& tissue, const VectorX& forces) {
    const auto of_contacts = forces.head(tissue.free.size());
    auto moved = scratch_.head(tissue.free.size());
    if (of_contacts.isZero(0.0)) {
        moved.setZero();
        return 0.0;
    }
    moved.noalias() = tissue.compliance.selfadjointView<Eigen::Lower>() * of_contacts;
    return 0.5 * of_contacts.dot(moved);
}

// What of the solved forces the next step and the ledger need to know of the tissue.
void Coupling::take_stock(const Linearisation& tissue, ContactSet& contacts) {
    (void)energy_of(tissue, forces_);
    for (std::size_t i = 0; i < contacts.rows.size(); ++i) {
        ContactRow& row = contacts.rows[i];
        const auto at = 3 * static_cast<Eigen::Index>(i);
        row.sideways = sideways_of(row, row.force);
        row.tissue_position = tissue.free.segment<3>(at) - scratch_.segment<3>(at);
    }
}

}    // namespace stylet::core
