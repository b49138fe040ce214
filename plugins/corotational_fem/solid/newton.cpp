#include "solid/newton.h"

#include "mesh/mass.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stylet::corotational_fem {

namespace {

// A step that leaves more of the residual than this has outlived its factor.
constexpr double worn = 0.1;
constexpr int most_halvings = 12;
constexpr double sufficient = 1e-4;    // of what the slope promises (Armijo 1966)
// Of the potential: rounding of sums over a mesh.
constexpr double rounding = 1e-13;

VectorX three_each(const VectorX& of_nodes) {
    VectorX all(3 * of_nodes.size());
    for (Eigen::Index i = 0; i < of_nodes.size(); ++i) all.segment<3>(3 * i).setConstant(of_nodes[i]);
    return all;
}

}    // namespace

Newton::Newton(const Mesh& mesh, std::span<const Material> materials, const Motion& motion)
    : solid_(mesh, materials, motion.share_pressure),
      motion_(motion),
      accuracy_(std::max(tolerance, solid_.rounding())),
      tangent_(mesh, motion.share_pressure),
      weight_(VectorX::Zero(3 * mesh.node_count())),
      load_(weight_),
      placed_(max_contacts),
      moved_(MatrixX::Zero(3 * mesh.node_count(), 3 * max_contacts)),
      compliance_(MatrixX::Zero(3 * max_contacts, 3 * max_contacts)),
      residual_(weight_),
      pressed_(weight_),
      ahead_(weight_),
      before_(weight_),
      damping_forces_(weight_),
      permuted_(3 * tangent_.free_nodes()) {
    for (Placed& placed : placed_) placed.footprint.reserve(mesh.nodes.size());
    if (motion.implicit || !motion.gravity.isZero(0.0)) {
        mass_ = three_each(lumped_mass(mesh, materials));
        for (const int node : tangent_.nodes()) weight_.segment<3>(3 * node) = mass_[3 * node] * motion.gravity;
    }
    trial_ = {.u = load_,
              .start = load_,
              .coasting = load_,
              .loads = load_,
              .inner = load_,
              .about = load_,
              .contact_forces = VectorX::Zero(3 * max_contacts)};
    state_ = origin_ = trial_;
    factor_.analyzePattern(tangent_.matrix());
    evaluate();
    about_ = trial_.u;
    if (!factorise(step_length(), Twists::exact)) {
        throw Error("fixed",
                    "found a mesh that is singular, wanted one that is held: part of it can move without being strained");
    }
    factor_step_ = step_length();
    stale_ = false;
    commit();
    origin_ = state_;
}

void Newton::load(std::span<const NodeForce> forces) {
    load_.setZero();
    for (const NodeForce& each : forces) load_.segment<3>(3 * each.node) += each.force;
}

void Newton::place(int contact, std::span<const NodeWeight> footprint) {
    placed_[contact].footprint.assign(footprint.begin(), footprint.end());
    placed_[contact].answered = false;
}

double Newton::step_length() const {
    return trial_.dt > 0.0 ? trial_.dt : motion_.dt;
}

void Newton::predict(double dt) {
    trial_.damping = state_.damping;
    trial_.numerical = state_.numerical;
    origin_ = trial_;
    trial_.loads = load_;
    if (dt > 0.0) {
        const double ahead = trial_.dt > 0.0 ? dt / trial_.dt : 0.0;
        trial_.coasting = trial_.u + ahead * (trial_.u - trial_.start);
        trial_.start = trial_.u;
        trial_.dt = dt;
        if (motion_.implicit) trial_.u = trial_.coasting;
    }
    evaluate();
}

void Newton::commit() {
    trial_.about = about_;
    trial_.factor_step = factor_step_;
    state_ = trial_;
}

// Bit for bit: the factor that the state was found with is made again.
void Newton::rollback() {
    trial_ = state_;
    contacts_ = 0;
    if (factor_step_ != state_.factor_step || about_ != state_.about) factorise(state_.about, state_.factor_step);
    stale_ = false;
    evaluate();
    trial_ = state_;
}

// Everything that the trial displacements say, without the forces from outside.
void Newton::evaluate() {
    trial_.inner.setZero();
    trial_.elastic = solid_.strain(trial_.u, trial_.inner);
    trial_.kinetic = 0.0;
    potential_ = trial_.elastic - (weighs() ? weight_.dot(trial_.u) : 0.0) - trial_.loads.dot(trial_.u);
    damping_forces_.setZero();
    if (motion_.damping_time > 0.0) {
        const double lost = solid_.damp(trial_.u, trial_.start, motion_.damping_time / step_length(), damping_forces_);
        potential_ += 0.5 * lost;
        trial_.inner += damping_forces_;
    }
    if (motion_.implicit) {
        const double rate = 1.0 / (step_length() * step_length());    // [1/s²]
        before_ = trial_.u - trial_.coasting;
        potential_ += 0.5 * rate * (mass_.array() * before_.array().square()).sum();
        trial_.inner.array() += rate * mass_.array() * before_.array();
        if (trial_.dt > 0.0) {
            trial_.kinetic = 0.5 * rate * (mass_.array() * (trial_.u - trial_.start).array().square()).sum();
        } else {
            trial_.inner += weight_;    // about to be let go: a = g
        }
    }
    keep_books(damping_forces_);
    balance();
}

// Energy lost since origin_: to the damper, and to the integrator by the trapezoid rule.
void Newton::keep_books(const VectorX& damping_forces) {
    before_ = trial_.u - origin_.u;
    const double damped = damping_forces.dot(before_);
    const double work = 0.5 * (origin_.inner + trial_.inner).dot(before_);
    trial_.damping = origin_.damping + damped;
    if (!motion_.implicit && !(motion_.damping_time > 0.0)) return;    // nothing is integrated
    trial_.numerical =
        origin_.numerical + work - damped - (trial_.elastic - origin_.elastic) - (trial_.kinetic - origin_.kinetic);
}

// r = w + f + Jᵀλ − inner
void Newton::balance() {
    pressed_.setZero();
    for (int i = 0; i < contacts_; ++i) {
        for (const auto& [node, weight] : placed_[i].footprint) {
            pressed_.segment<3>(3 * node) += weight * trial_.contact_forces.segment<3>(3 * i);
        }
    }
    residual_.setZero();
    for (const int node : tangent_.nodes()) {
        const auto at = 3 * node;
        residual_.segment<3>(at) =
            weight_.segment<3>(at) + trial_.loads.segment<3>(at) + pressed_.segment<3>(at) - trial_.inner.segment<3>(at);
    }
}

double Newton::imbalance() const {
    double greatest = 0.0;
    for (const int node : tangent_.nodes()) greatest = std::max(greatest, residual_.segment<3>(3 * node).norm());
    return std::isfinite(residual_.sum()) ? greatest : std::numeric_limits<double>::infinity();
}

// The true tangent where it is definite; that of the unstrained mesh, which always is, where nothing else can be.
void Newton::factorise(const VectorX& u, double dt) {
    about_ = u;
    if (!factorise(dt, Twists::exact) && !factorise(dt, Twists::definite)) {
        about_.setZero();
        (void)factorise(dt, Twists::exact);
    }
    factor_step_ = dt;
    stale_ = false;
    for (Placed& placed : placed_) placed.answered = false;
}

// About about_, the damper's frames too: they differ from those of the step's start by next to nothing.
bool Newton::factorise(double dt, Twists twists) {
    tangent_.clear();
    solid_.stiffen(about_, twists, tangent_);
    if (motion_.damping_time > 0.0) solid_.stiffen_damper(about_, motion_.damping_time / dt, tangent_);
    if (motion_.implicit) {
        for (const int node : tangent_.nodes()) {
            tangent_.add(node, node, mass_[3 * node] / (dt * dt) * Matrix3::Identity());
        }
    }
    factor_.factorize(tangent_.matrix());
    diagonal_ = factor_.vectorD();
    ++factorisations_;
    return factor_.info() == Eigen::Success && diagonal_.minCoeff() > 0.0;
}

// Permuted by hand: Eigen's products with a permutation allocate.
void Newton::solve(const VectorX& forces, VectorX& displacements) {
    const auto& places = factor_.permutationP().indices();    // of each row in the factor
    for (int i = 0; i < tangent_.free_nodes(); ++i) {
        for (int k = 0; k < 3; ++k) permuted_[places[3 * i + k]] = forces[3 * tangent_.nodes()[i] + k];
    }
    displacements.setZero();    // of held nodes: `forces` may be the same vector
    factor_.matrixL().solveInPlace(permuted_);
    permuted_.array() /= diagonal_.array();
    factor_.matrixU().solveInPlace(permuted_);
    for (int i = 0; i < tangent_.free_nodes(); ++i) {
        for (int k = 0; k < 3; ++k) displacements[3 * tangent_.nodes()[i] + k] = permuted_[places[3 * i + k]];
    }
}

// The mesh under a newton on each direction of a contact, and how far that moves those answered before.
void Newton::answer(int contact) {
    for (int direction = 0; direction < 3; ++direction) {
        before_.setZero();
        for (const auto& [node, weight] : placed_[contact].footprint) before_[3 * node + direction] += weight;
        solve(before_, before_);
        column(contact, direction) = before_;
    }
    placed_[contact].answered = true;
    for (int other = 0; other < max_contacts; ++other) {
        if (!placed_[other].answered) continue;
        Matrix3 block = Matrix3::Zero();
        for (const auto& [node, weight] : placed_[other].footprint) {
            block += weight * moved_.block<3, 3>(3 * node, 3 * contact);
        }
        if (other == contact) block = (0.5 * (block + block.transpose())).eval();
        compliance_.block<3, 3>(3 * other, 3 * contact) = block;
        compliance_.block<3, 3>(3 * contact, 3 * other) = block.transpose();
    }
}

Vector3 Newton::mean(const Placed& placed, const VectorX& u) {
    Vector3 sum = Vector3::Zero();
    for (const auto& [node, weight] : placed.footprint) sum += weight * u.segment<3>(3 * node);
    return sum;
}

void Newton::linearise(int contacts, Eigen::Ref<VectorX> free, Eigen::Ref<MatrixX, 0, Eigen::OuterStride<>> compliance) {
    if (stale_ || factor_step_ != step_length()) factorise(trial_.u, step_length());
    contacts_ = contacts;
    trial_.contact_forces.tail(3 * (max_contacts - contacts)).setZero();
    for (int i = 0; i < contacts; ++i) {
        if (!placed_[i].answered) answer(i);
    }
    balance();
    if (imbalance() > accuracy_) {
        solve(residual_, ahead_);
    } else {
        ahead_.setZero();
    }
    compliance = compliance_.topLeftCorner(3 * contacts, 3 * contacts);
    for (int i = 0; i < contacts; ++i) free.segment<3>(3 * i) = mean(placed_[i], trial_.u) + mean(placed_[i], ahead_);
    free.noalias() -= compliance * trial_.contact_forces.head(3 * contacts);
}

void Newton::take_forces(const Forces& forces) {
    contacts_ = static_cast<int>(forces.size()) / 3;
    trial_.contact_forces.setZero();
    trial_.contact_forces.head(forces.size()) = forces;
    balance();
}

StepReport Newton::try_step(Forces forces) {
    take_forces(forces);
    const double before = imbalance();
    if (before <= accuracy_) return {.residual = 0.0};
    solve(residual_, ahead_);
    const double slope = residual_.dot(ahead_);    // [J] by which the potential falls along the step, to first order
    const double start = potential_ - pressed_.dot(trial_.u);
    const double noise = rounding * (std::abs(potential_) + std::abs(start) + trial_.elastic);
    const auto falls = [&](double length) {
        return potential_ - pressed_.dot(trial_.u) <= start - sufficient * length * slope + noise;
    };
    double length = 1.0;
    trial_.u += ahead_;
    evaluate();
    for (int i = 0; i < most_halvings && !falls(length); ++i) {
        length *= 0.5;
        trial_.u -= length * ahead_;
        evaluate();
    }
    const double after = imbalance();
    stale_ = after > accuracy_ && !(after <= worn * before);
    return {.residual = after <= accuracy_ ? 0.0 : after};
}

EnergyReport Newton::energy() const {
    return {.stored = trial_.elastic - weight_.dot(trial_.u),
            .kinetic = trial_.kinetic,
            .damping = trial_.damping,
            .numerical = trial_.numerical};
}

}    // namespace stylet::corotational_fem
