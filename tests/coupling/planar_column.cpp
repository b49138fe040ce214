#include "planar_column.h"

#include <cmath>
#include <limits>

namespace stylet::core {

namespace {

using Pair = Eigen::Vector2d;
using Block = Eigen::Matrix2d;

constexpr int along = 0, across = 1;

// An element: its direction, the direction in which it turns, and how long it is.
struct Edge {
    Pair tangent, normal;
    double length, stretch;    // [m]
    double angle;              // [rad] to the straight needle

    Edge(double rest, const Pair& change) {
        const Pair edge = Pair(rest, 0.0) + change;
        length = edge.norm();
        stretch = (2.0 * rest * change[along] + change.squaredNorm()) / (length + rest);    // length − rest, without cancelling
        tangent = edge / length;
        normal = {-tangent[across], tangent[along]};
        angle = std::atan2(edge[across], edge[along]);
    }
    [[nodiscard]] Pair angle_gradient() const { return normal / length; }
    [[nodiscard]] Block angle_hessian() const {
        return -(tangent * normal.transpose() + normal * tangent.transpose()) / (length * length);
    }
};

int negatives_of(const MatrixX& tangent) {
    const VectorX eigenvalues = Eigen::SelfAdjointEigenSolver<MatrixX>(tangent, Eigen::EigenvaluesOnly).eigenvalues();
    return static_cast<int>((eigenvalues.array() < 0.0).count());
}

}    // namespace

PlanarColumn::PlanarColumn(const ColumnSetup& setup, const Pose& base)
    : setup_(setup), element_(setup.length / setup.elements), mass_(setup.line_density * element_) {
    const Eigen::Index size = 2 * setup.elements;
    masses_ = VectorX::Constant(size, mass_);
    masses_.tail<2>() *= 0.5;
    committed_.base = base;
    committed_.displacement = VectorX::Zero(size);
    committed_.velocity = VectorX::Zero(size);
    committed_.inertia = VectorX::Zero(size);
    contact_forces_ = VectorX::Zero(size);
    trial_ = committed_;
}

Eigen::Matrix<double, 3, 2> PlanarColumn::directions() const {
    Eigen::Matrix<double, 3, 2> both;
    both << trial_.base.axis(), trial_.base.bow_direction();
    return both;
}

PlanarColumn::Pair PlanarColumn::node(const VectorX& displacement, int i) const {
    return i == 0 ? Pair::Zero() : Pair(displacement.segment<2>(2 * (i - 1)));
}

// Every energy is a function of one element's vector or two; each node at an element's end takes its derivatives, with a sign.
PlanarColumn::Elastic PlanarColumn::elastic(const VectorX& displacement) const {
    const Eigen::Index size = displacement.size();
    Elastic sum{.energy = 0.0, .gradient = VectorX::Zero(size), .tangent = MatrixX::Zero(size, size)};
    const auto add_force = [&](int edge, const Pair& force) {
        sum.gradient.segment<2>(2 * edge) += force;
        if (edge > 0) sum.gradient.segment<2>(2 * (edge - 1)) -= force;
    };
    const auto add_tangent = [&](int edge, int other, const Block& block) {
        for (const int i : {edge, edge - 1}) {
            for (const int j : {other, other - 1}) {
                const double sign = (i == edge) == (j == other) ? 1.0 : -1.0;
                if (i >= 0 && j >= 0) sum.tangent.block<2, 2>(2 * i, 2 * j) += sign * block;
            }
        }
    };
    const double stretching = setup_.axial_stiffness / element_, bending = setup_.bending_stiffness / element_;
    Edge before(element_, Pair::Zero());    // the clamp
    for (int i = 0; i < setup_.elements; ++i) {
        const Edge edge(element_, node(displacement, i + 1) - node(displacement, i));
        const double tension = stretching * edge.stretch;
        sum.energy += 0.5 * tension * edge.stretch;
        add_force(i, tension * edge.tangent);
        add_tangent(
            i, i,
            stretching * edge.tangent * edge.tangent.transpose() + tension / edge.length * edge.normal * edge.normal.transpose());

        const double stiffness = i == 0 ? 2.0 * bending : bending;
        const double turn = edge.angle - before.angle;
        const Pair gradient = edge.angle_gradient(), gradient_before = before.angle_gradient();
        sum.energy += 0.5 * stiffness * turn * turn;
        add_force(i, stiffness * turn * gradient);
        add_tangent(i, i, stiffness * (gradient * gradient.transpose() + turn * edge.angle_hessian()));
        if (i > 0) {
            add_force(i - 1, -stiffness * turn * gradient_before);
            add_tangent(i - 1, i - 1,
                        stiffness * (gradient_before * gradient_before.transpose() - turn * before.angle_hessian()));
            add_tangent(i, i - 1, -stiffness * gradient * gradient_before.transpose());
            add_tangent(i - 1, i, -stiffness * gradient_before * gradient.transpose());
        }
        before = edge;
    }
    return sum;
}

// How far the base has carried every node in this step.
VectorX PlanarColumn::carried() const {
    const Pair base = directions().transpose() * (trial_.base.position - committed_.base.position);
    return base.replicate(setup_.elements, 1);
}

// M (x − xₙ − dt vₙ)/dt², x in world: the base's motion is part of every node's.
VectorX PlanarColumn::inertia_forces(const VectorX& displacement) const {
    if (dt_ == 0.0) return VectorX::Zero(displacement.size());
    const VectorX moved = displacement - committed_.displacement + carried() - dt_ * committed_.velocity;
    return masses_.cwiseProduct(moved) / (dt_ * dt_);
}

VectorX PlanarColumn::imbalance(const VectorX& displacement) const {
    VectorX force = -elastic(displacement).gradient - inertia_forces(displacement);
    force[2 * (setup_.elements / 2 - 1) + across] += setup_.side_force;
    return force;
}

// Backward Euler loses what the inertia forces' work by the trapezoid rule exceeds the change of kinetic energy by: the rule of
// the ledger, so that only the curvature of the elastic energy within a step is left to its residual.
EnergyReport PlanarColumn::energy_of(const VectorX& displacement) const {
    EnergyReport report = committed_.energy;
    report.stored = elastic(displacement).energy - setup_.side_force * node(displacement, setup_.elements / 2)[across];
    if (dt_ == 0.0) return report;
    const VectorX moved = displacement - committed_.displacement + carried();
    report.kinetic = 0.5 * moved.dot(masses_.cwiseProduct(moved)) / (dt_ * dt_);
    report.numerical +=
        0.5 * moved.dot(committed_.inertia + inertia_forces(displacement)) - (report.kinetic - committed_.energy.kinetic);
    return report;
}

void PlanarColumn::predict(const Pose& base, double, double dt) {
    trial_.base = base;
    dt_ = dt;
}

MatrixX PlanarColumn::interpolation(ContactPoints points) const {
    MatrixX weights = MatrixX::Zero(3 * static_cast<Eigen::Index>(points.size()), masses_.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double place = points[i].arclength / element_;
        const int first = std::min(static_cast<int>(place), setup_.elements - 1);
        const double part = place - first;
        const auto at = 3 * static_cast<Eigen::Index>(i);
        weights.block<3, 2>(at, 2 * first) = part * directions();
        if (first > 0) weights.block<3, 2>(at, 2 * (first - 1)) = (1.0 - part) * directions();
    }
    return weights;
}

Linearisation PlanarColumn::linearise(ContactPoints points, double shift) {
    ++linearisations_;
    MatrixX tangent = elastic(trial_.displacement).tangent;
    if (dt_ > 0.0) tangent.diagonal() += masses_ / (dt_ * dt_);
    negatives_ = negatives_of(tangent);
    tangent.diagonal() += shift * masses_;
    solver_.compute(tangent);
    const MatrixX weights = interpolation(points);
    const VectorX step = solver_.solve(imbalance(trial_.displacement));
    free_ = weights * step;
    for (std::size_t i = 0; i < points.size(); ++i) {
        free_.segment<3>(3 * static_cast<Eigen::Index>(i)) += position(points[i].arclength);
    }
    const MatrixX compliance = weights * solver_.solve(weights.transpose());
    compliance_ = 0.5 * (compliance + compliance.transpose());
    return {.free = {free_.data(), free_.size()},
            .compliance = {compliance_.data(), compliance_.rows(), compliance_.cols(), Eigen::OuterStride<>(compliance_.rows())},
            .negatives = negatives_of(tangent)};
}

StepReport PlanarColumn::try_step(ContactPoints points, Forces forces) {
    contact_forces_ = interpolation(points).transpose() * forces;
    trial_.displacement += solver_.solve(imbalance(trial_.displacement) + contact_forces_);
    trial_.energy = energy_of(trial_.displacement);
    MatrixX tangent = elastic(trial_.displacement).tangent;
    if (dt_ > 0.0) tangent.diagonal() += masses_ / (dt_ * dt_);
    const double residual = (imbalance(trial_.displacement) + contact_forces_).lpNorm<Eigen::Infinity>();
    return {.residual = residual, .tangent_changed = negatives_of(tangent) != negatives_};
}

void PlanarColumn::commit() {
    trial_.inertia = inertia_forces(trial_.displacement);
    VectorX balance = trial_.inertia - contact_forces_;
    balance[2 * (setup_.elements / 2 - 1) + across] -= setup_.side_force;
    Pair held = Pair::Zero();
    for (int i = 0; i < setup_.elements; ++i) held += balance.segment<2>(2 * i);
    wrench_.force = directions() * held;
    if (dt_ > 0.0) trial_.velocity = (trial_.displacement - committed_.displacement + carried()) / dt_;
    committed_ = trial_;
}

Vector3 PlanarColumn::position(double arclength) const {
    const double place = arclength / element_;
    const int first = std::min(static_cast<int>(place), setup_.elements - 1);
    const double part = place - first;
    const Pair moved = (1.0 - part) * node(trial_.displacement, first) + part * node(trial_.displacement, first + 1);
    return trial_.base.position + arclength * trial_.base.axis() + directions() * moved;
}

Vector3 PlanarColumn::tangent(double arclength) const {
    const int first = std::min(static_cast<int>(arclength / element_), setup_.elements - 1);
    const Edge edge(element_, node(trial_.displacement, first + 1) - node(trial_.displacement, first));
    return directions() * edge.tangent;
}

NeedleState PlanarColumn::state() const {
    NeedleState state{.critical_load = std::numeric_limits<double>::infinity(),
                      .axial_load = wrench_.force.dot(committed_.base.axis())};
    for (int i = 1; i <= setup_.elements; ++i) {
        state.deflection = std::max(state.deflection, std::abs(node(committed_.displacement, i)[across]));
        const Edge edge(element_, node(committed_.displacement, i) - node(committed_.displacement, i - 1));
        state.slope = std::max(state.slope, std::abs(edge.angle));
    }
    return state;
}

void PlanarColumn::centreline(std::span<Vector3> points) const {
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i] = position(setup_.length * static_cast<double>(i) / static_cast<double>(points.size() - 1));
    }
}

MatrixX PlanarColumn::straight_tangent(double compression) const {
    VectorX displacement = VectorX::Zero(masses_.size());
    for (int i = 0; i < setup_.elements; ++i) {
        displacement[2 * i + along] = -(i + 1) * element_ * compression / setup_.axial_stiffness;
    }
    return elastic(displacement).tangent;
}

double PlanarColumn::bow() const {
    return node(trial_.displacement, setup_.elements / 2)[across];
}

Linearisation SpringTissue::linearise(ContactPoints points, double) {
    const auto count = static_cast<Eigen::Index>(points.size());
    free_.resize(3 * count);
    compliance_ = MatrixX::Zero(3 * count, 3 * count);
    for (Eigen::Index i = 0; i < count; ++i) {
        free_.segment<3>(3 * i) = points[static_cast<std::size_t>(i)].material;
        for (Eigen::Index j = 0; j < count; ++j) {
            const double shared = std::exp(-static_cast<double>(std::abs(i - j)));
            compliance_.block<3, 3>(3 * i, 3 * j) = shared * springs_.asDiagonal().toDenseMatrix();
        }
    }
    return {.free = {free_.data(), free_.size()},
            .compliance = {compliance_.data(), compliance_.rows(), compliance_.cols(), Eigen::OuterStride<>(compliance_.rows())}};
}

StepReport SpringTissue::try_step(ContactPoints, Forces forces) {
    trial_ = 0.5 * forces.dot(compliance_ * forces);
    return {};
}

Location SpringTissue::locate(const Vector3& material) const {
    return {.layer = material.z() > 0.0 ? outside : 0, .depth = -material.z()};
}

}    // namespace stylet::core
