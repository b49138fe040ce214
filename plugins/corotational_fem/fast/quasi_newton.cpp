#include "fast/quasi_newton.h"

#include "fast/faithful_panels.h"
#include "mesh/mass.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stylet::corotational_fem {

namespace {

// In one call, each with a few passes at worst; what they leave undone, the next call does.
constexpr int most_iterations = 10;

// Of the accuracy: what forces that another linearisation corrects may leave undone.
constexpr double negligible = 1e-3;
// Of a tissue that comes to rest: numbers too small for the processor to be quick with.
constexpr float nothing = 1e-20F;    // [m]
// A contact may end so far beside where its force was found for: what that leaves of work is nothing in the books, and single
// precision knows its place no better.
constexpr double beside_contact = 1e-8;    // [m]
constexpr double beside_share = 1e-6;      // of its displacement

bool has_mass(const Motion& motion) {
    return motion.implicit || !motion.gravity.isZero(0.0);
}

std::vector<float> masses(const Mesh& mesh, std::span<const Material> materials, const BlockMatrix& matrix,
                          const Dissection& dissection) {
    const VectorX mass = lumped_mass(mesh, materials);
    std::vector<float> masses(matrix.rows());
    for (int row = 0; row < matrix.rows(); ++row) masses[dissection.place[row]] = static_cast<float>(mass[matrix.mesh_node[row]]);
    return masses;
}

std::vector<float> softnesses(const BlockMatrix& matrix, const Dissection& dissection) {
    std::vector<float> softnesses(matrix.rows());
    for (int row = 0; row < matrix.rows(); ++row) {
        const auto begin = matrix.column.begin() + matrix.start[row], end = matrix.column.begin() + matrix.start[row + 1];
        const auto at = std::lower_bound(begin, end, row) - matrix.column.begin();
        softnesses[dissection.place[row]] = static_cast<float>(3.0 / matrix.block[at].trace());
    }
    return softnesses;
}

std::unique_ptr<Panels> factorised(const BlockMatrix& matrix, const Dissection& dissection, Workers& workers,
                                   InstructionSet set) {
    Factor factor(dissection, set);
    factor.refactor(matrix, workers);
    return faithful_panels(factor, matrix, set, workers);
}

}    // namespace

QuasiNewton::QuasiNewton(const Mesh& mesh, std::span<const Material> materials, const Motion& motion, double accuracy,
                         Workers& workers, InstructionSet set)
    : QuasiNewton(mesh, materials, motion, accuracy, workers, set, rest_matrix(mesh, materials, motion)) {}

QuasiNewton::QuasiNewton(const Mesh& mesh, std::span<const Material> materials, const Motion& motion, double accuracy,
                         Workers& workers, InstructionSet set, const BlockMatrix& matrix)
    : motion_(motion),
      accuracy_(accuracy),
      workers_(workers),
      dissection_(dissect(matrix)),
      panels_(factorised(matrix, dissection_, workers, set)),
      elements_(mesh, materials, dissection_.place_of_node, motion.share_pressure, motion.damping_time > 0.0, workers, set),
      contacts_(*panels_, workers),
      loops_(dissection_.places(), workers),
      pairs_(loops_),
      nodes_(dissection_.places()),
      mass_(nodes_, 0.0F),
      softness_(softnesses(matrix, dissection_)),
      node_loads_(nodes_ + 1),
      x_(nodes_ + 1),
      start_(nodes_ + 1),
      outer_(nodes_ + 1),
      residual_(nodes_),
      before_(nodes_),
      q_(nodes_ + 1),
      foreseen_(VectorX::Zero(3 * max_contacts)),
      changed_(3 * max_contacts),
      moved_(3 * max_contacts),
      answer_(nodes_ + 1),
      ahead_(nodes_ + 1) {
    if (has_mass(motion)) mass_ = masses(mesh, materials, matrix, dissection_);
    trial_.from.resize(nodes_ + 1);
    for (NodalVector* each : {&trial_.moved, &trial_.loads}) each->resize(nodes_ + 1);
    for (NodalVector* each : {&trial_.coasting, &trial_.inner, &origin_.moved, &origin_.resisting}) each->resize(nodes_);
    trial_.lambda.resize(3 * max_contacts);
    if (damped()) start_damper(trial_.inner);
    gather_loads();
    evaluate();
    open_books();
    close_books();
    state_ = trial_;
}

void QuasiNewton::load(std::span<const NodeForce> forces) {
    std::fill(node_loads_.begin(), node_loads_.end(), Float4{});
    for (const auto& [node, force] : forces) {
        Float4& at = node_loads_[dissection_.place_of_node[node]];
        at.x += static_cast<float>(force.x());
        at.y += static_cast<float>(force.y());
        at.z += static_cast<float>(force.z());
    }
}

// Weight, unless the tissue has inertia and its clock stands still, and the loads. Returns whether they have changed.
bool QuasiNewton::gather_loads() {
    const bool weighs = !motion_.implicit || trial_.dt > 0.0;
    const Vector3 pull = weighs ? motion_.gravity : Vector3(Vector3::Zero());
    const Quad gravity{static_cast<float>(pull.x()), static_cast<float>(pull.y()), static_cast<float>(pull.z()), 0.0F};
    bool changed = false;
    for (int i = 0; i < nodes_; ++i) {
        Float4 load;
        quad(load) = quad(node_loads_[i]) + mass_[i] * gravity;
        Float4& at = trial_.loads[i];
        changed = changed || load.x != at.x || load.y != at.y || load.z != at.z;
        at = load;
    }
    if (changed) trial_.settled = outer_known_ = false;
    return changed;
}

void QuasiNewton::place(int contact, std::span<const NodeWeight> footprint) {
    contacts_.place(contact, footprint);
    ahead_known_ = rested_ = false;
    placed_anew_ = true;
    const auto first = trial_.lambda.begin() + 3 * contact;
    if (std::any_of(first, first + 3, [](double force) { return force != 0.0; })) trial_.settled = outer_known_ = false;
}

void QuasiNewton::predict(double dt) {
    const bool still = std::exchange(polished_, false) && trial_.settled && !motion_.implicit && !damped();
    ahead_known_ = false;
    open_books();
    if (dt > 0.0) start_step(dt);
    rested_ = !gather_loads() && still && dt > 0.0;
}

// From the trial state on. It is not moved yet: the pairs know where it is going as well as its inertia does.
void QuasiNewton::start_step(double dt) {
    const float ahead = trial_.dt > 0.0 ? static_cast<float>(dt / trial_.dt) : 0.0F;
    loops_.each([&](int i) {
        Quad& moved = quad(trial_.moved[i]);
        moved = ((moved > nothing) | (moved < -nothing)) ? moved : Quad{};
        reinterpret_cast<DoubleQuad&>(trial_.from[i]) += __builtin_convertvector(moved, DoubleQuad);
        quad(trial_.coasting[i]) = ahead * moved;
        moved = Quad{};
        origin_.moved[i] = {};
    });
    trial_.dt = dt;
    trial_.weight_before = trial_.weight;
    trial_.settled = false;
    if (damped()) start_damper(trial_.inner);    // without the last step's damping
    trial_.dissipated = 0.0;
    origin_.dissipated = 0.0;
}

void QuasiNewton::linearise(int contacts, Eigen::Ref<VectorX> free, Eigen::Ref<MatrixX, 0, Eigen::OuterStride<>> compliance) {
    set_forces({trial_.lambda.data(), static_cast<std::size_t>(3 * contacts)});
    if (contacts == 0) return;
    if (!trial_.settled && !rested_ && !ahead_known_) {
        balance();
        find_direction();
    }
    compliance = contacts_.compliance(contacts);
    const Eigen::Map<const VectorX> lambda(trial_.lambda.data(), 3 * contacts);
    free.noalias() = -compliance * lambda;
    for (int i = 0; i < contacts; ++i) {
        free.segment<3>(3 * i) += contacts_.mean(i, x_);
        if (ahead_known_) free.segment<3>(3 * i) += contacts_.mean(i, ahead_);
    }
}

void QuasiNewton::set_forces(std::span<const double> lambda) {
    const auto acting = trial_.lambda.begin() + 3 * trial_.contacts;
    const auto rest = std::min(trial_.lambda.begin() + static_cast<std::ptrdiff_t>(lambda.size()), acting);
    const bool same = std::equal(lambda.begin(), lambda.end(), trial_.lambda.begin()) &&
                      std::all_of(rest, acting, [](double force) { return force == 0.0; });
    std::copy(lambda.begin(), lambda.end(), trial_.lambda.begin());
    std::fill(trial_.lambda.begin() + static_cast<std::ptrdiff_t>(lambda.size()), trial_.lambda.end(), 0.0);
    trial_.contacts = static_cast<int>(lambda.size()) / 3;
    if (!same) trial_.settled = rested_ = ahead_known_ = outer_known_ = false;
}

// What other forces on the same contacts add goes through the factor alone, as the compliance that linearise told has it.
void QuasiNewton::push(std::span<const double> lambda, NodalVector& answer) {
    for (int i = 0; i < trial_.contacts; ++i) {
        const Eigen::Map<const Vector3> force(lambda.data() + 3 * i), before(trial_.lambda.data() + 3 * i);
        contacts_.push(i, answer_scale() * (force - before));
    }
    panels_->backward(answer.data(), workers_);
}

// The step that is known, for other forces.
void QuasiNewton::redirect(std::span<const double> lambda) {
    push(lambda, q_);
    loops_.each([&](int i) { quad(ahead_[i]) += quad(q_[i]) - quad(answer_[i]); });
    set_forces(lambda);
    balance();
    ahead_known_ = true;
}

// The step from rest: other forces are all that is out of balance, but for what accuracy has left. Where that outweighs them, a
// direction has to be found for both, and where it leads is held against what linearise told.
void QuasiNewton::head_for(std::span<const double> lambda) {
    constexpr double most_left = 0.5;    // of the work that the step promises
    panels_->clear();
    push(lambda, ahead_);
    foresee();
    const auto rows = static_cast<Eigen::Index>(lambda.size());
    const double promised = moved_by(lambda).dot(changed_.head(rows));
    set_forces(lambda);
    ahead_known_ = balance() > (1.0 - most_left) * promised;
}

// [m] By how much other forces on the same contacts would move them, by the factor; changed_ has what is other about them.
Eigen::Ref<const VectorX> QuasiNewton::moved_by(std::span<const double> lambda) {
    const auto rows = static_cast<Eigen::Index>(lambda.size());
    const Eigen::Map<const VectorX> forces(lambda.data(), rows), before(trial_.lambda.data(), rows);
    changed_.head(rows) = forces - before;
    moved_.head(rows).noalias() = contacts_.compliance(trial_.contacts) * changed_.head(rows);
    return moved_.head(rows);
}

// Whether other forces on the same contacts would move them by nothing that counts.
bool QuasiNewton::same_to_accuracy(std::span<const double> lambda) {
    return is_for_contacts(lambda) && moved_by(lambda).norm() <= negligible * accuracy_ * size_;
}

StepReport QuasiNewton::try_step(Forces forces) {
    // What single precision can't hold would stay in the solver's memory for good.
    if (!forces.cast<float>().allFinite()) return {.residual = std::numeric_limits<double>::infinity()};
    const std::span<const double> lambda(forces.data(), static_cast<std::size_t>(forces.size()));
    if (trial_.settled && same_to_accuracy(lambda)) {
        return {};    // λ stays what the state is in balance with, so that many such changes add up to one that counts
    }
    const bool same = is_for_contacts(lambda) && std::equal(lambda.begin(), lambda.end(), trial_.lambda.begin());
    if (rested_ && same) {
        trial_.settled = true;
        return {};
    }
    const bool foreseen = !trial_.settled && is_for_contacts(lambda) && (rested_ || ahead_known_);
    if (foreseen && rested_) {
        head_for(lambda);
    } else if (foreseen) {
        if (!same) redirect(lambda);
        foresee();
    } else {
        set_forces(lambda);
        if (trial_.settled) return {};
        if (!ahead_known_) balance();
    }
    last_step_ = 0.0;
    for (int i = 0; i < most_iterations && !trial_.settled; ++i) trial_.settled = iterate();
    polished_ = trial_.settled;
    rested_ = false;
    close_books();
    if (!trial_.settled) return {.residual = imbalance()};
    return {.residual = foreseen ? astray() : 0.0};
}

// Where the forces on the contacts were found to bring them.
void QuasiNewton::foresee() {
    for (int i = 0; i < trial_.contacts; ++i) foreseen_.segment<3>(3 * i) = contacts_.mean(i, x_) + contacts_.mean(i, ahead_);
}

// The tissue is in balance under these forces, but they were found for contacts elsewhere: zero where they ended as foreseen,
// else what it would take to bring them there [N].
double QuasiNewton::astray() {
    double greatest = 0.0;
    const auto& compliance = contacts_.compliance(trial_.contacts);
    for (int i = 0; i < trial_.contacts; ++i) {
        const Vector3 there = foreseen_.segment<3>(3 * i);
        const double beside = (contacts_.mean(i, x_) - there).norm();
        if (beside <= beside_contact + beside_share * there.norm()) continue;
        greatest = std::max(greatest, beside / compliance(3 * i + 2, 3 * i + 2));
    }
    return greatest;
}

void QuasiNewton::commit() {
    state_ = trial_;
    placed_anew_ = polished_ = rested_ = false;
    pairs_.commit();
}

void QuasiNewton::rollback() {
    trial_ = state_;
    pairs_.rollback();
    ahead_known_ = outer_known_ = polished_ = rested_ = false;
    if (placed_anew_) trial_.settled = false;
    placed_anew_ = false;
    std::fill(ahead_.begin(), ahead_.end(), Float4{});
    if (damped()) start_damper(q_);
    move(0.0F);
}

Vector3 QuasiNewton::displacement(int node) const {
    const int place = dissection_.place_of_node[node];
    const Place& from = trial_.from[place];
    const Float4& moved = trial_.moved[place];
    return {from.x + double{moved.x}, from.y + double{moved.y}, from.z + double{moved.z}};
}

}    // namespace stylet::corotational_fem
