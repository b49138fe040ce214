#include "rod.h"

#include "parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace stylet::rod {

namespace {

using std::numbers::pi;

// [rad] Where a pinned column meets itself (its elastica's end slope).
constexpr double touches_itself = 130.7 * pi / 180.0;
constexpr double most_imperfect = 1e-3;              // of the length
constexpr double bows = 1e-2, straightens = 5e-3;    // of the free length
// A change of the axial force that could bring the next linearisation to another branch, in EI/L²: the least critical load
// is 2.47.
constexpr double noticeable = 1e-2;

ChainSetup chain_of(const Setup& setup) {
    const NeedleSetup& needle = *setup.needle;
    if (needle.ends == Ends::clamped_clamped)
        throw Error("needle.ends",
                    "found 'clamped-clamped', wanted one whose far end is free or pinned: a rod's tip is held by "
                    "what it touches, and what it touches holds no direction");
    const Parameters& given = setup.parameters;
    const double imperfection = given.number("imperfection");    // [m]
    if (imperfection > most_imperfect * needle.length)
        throw Error("imperfection", "found a bow of " + std::to_string(imperfection / needle.length) +
                                        " of the needle's length, wanted at most a thousandth: what is bent on purpose has a "
                                        "natural_curvature");
    const int edges = static_cast<int>(given.integer("nodes")) - 1;
    const double shear_modulus = needle.youngs_modulus / (2.0 * (1.0 + given.number("poisson_ratio")));    // [Pa]
    ChainSetup chain{.edges = edges,
                     .length = needle.length,
                     .section = {.stretching = needle.youngs_modulus * needle.area(),
                                 .bending = Vector2::Constant(needle.bending_stiffness()),
                                 .twisting = 2.0 * shear_modulus * needle.second_moment()},
                     .clamped = needle.ends != Ends::pinned_pinned,
                     .natural_curvature = {}};
    const double curvature = given.has("natural_curvature") ? given.number("natural_curvature") : 0.0;
    const double wave = 2.0 * pi / needle.length;
    for (int i = 0; i < edges; ++i) {    // w'' of a (1 − cos(2πs/L))/2
        const double s = needle.length * i / edges;
        chain.natural_curvature.push_back(curvature + 0.5 * imperfection * wave * wave * std::cos(wave * s));
    }
    return chain;
}

}    // namespace

Rod::Rod(const Setup& setup)
    : needle_(*setup.needle),
      chain_(chain_of(setup)),
      edge_mass_(setup.parameters.number("density") * needle_.area() * chain_.edge_length()),
      retardation_(setup.parameters.has("damping_time") ? setup.parameters.number("damping_time") : 0.0),
      cut_angle_(setup.parameters.has("bevel_cut_angle") ? setup.parameters.number("bevel_cut_angle") : 0.0),
      tangent_(chain_.unknowns()),
      imbalance_(VectorX::Zero(chain_.unknowns())),
      step_(VectorX::Zero(chain_.unknowns())),
      change_(VectorX::Zero(chain_.unknowns())),
      columns_(Columns::Zero(chain_.unknowns(), 3 * max_contacts)),
      starts_(3 * max_contacts),
      order_(max_contacts),
      spots_(max_contacts),
      free_(VectorX::Zero(3 * max_contacts)),
      compliance_(MatrixX::Zero(3 * max_contacts, 3 * max_contacts)) {
    trial_.free_length = needle_.length;
    trial_.shape = chain_.straight();
    lay(trial_.shape);
    trial_.tensions.assign(chain_.edges(), 0.0);
    for (auto* places : {&trial_.start, &trial_.coasting, &trial_.places, &trial_.inertia})
        places->assign(chain_.nodes(), Vector3::Zero());
    trial_.viscous.assign(chain_.edges(), Vector3::Zero());
    trial_.elastic = VectorX::Zero(chain_.unknowns());
    trial_.strains.assign(chain_.edges(), Strain::Zero());
    for (int i = 0; i < chain_.edges(); ++i) trial_.strains[i] = chain_.strain(trial_.shape, i);
    trial_.bent = trial_.strains;
    trial_.energy.stored = chain_.energy(trial_.shape);
    state_ = trial_;
}

// As its natural curvature leaves it, in the plane of its first directors.
void Rod::lay(Shape& shape) const {
    double angle = 0.0;    // [rad] from the axis
    for (int i = 0; i < chain_.edges(); ++i) {
        angle += 2.0 * std::atan(0.5 * chain_.setup().natural_curvature[i] * chain_.joint_length(i));
        const Vector3 tangent(std::sin(angle), 0.0, -std::cos(angle));
        shape.displacement[i + 1] = shape.displacement[i] + chain_.edge_length() * (tangent - Chain::axis);
        shape.reference[i] = {std::cos(angle), 0.0, std::sin(angle)};
    }
}

Vector3 Rod::place(const State& state, int node) const {
    return state.base.position +
           state.base.rotation * Vector3(node * chain_.edge_length() * Chain::axis + state.shape.displacement[node]);
}

Vector3 Rod::place(const State& state, const Spot& spot, double arclength) const {
    return state.base.position + state.base.rotation * Vector3(arclength * Chain::axis + spot.displacement(state.shape));
}

double Rod::node_mass(int node) const {
    return node == 0 || node == chain_.edges() ? 0.5 * edge_mass_ : edge_mass_;
}

// [N] world.
Vector3 Rod::inertia(const State& state, int node) const {
    if (!(state.dt > 0.0)) return Vector3::Zero();
    return node_mass(node) / (state.dt * state.dt) * (place(state, node) - state.coasting[node]);
}

void Rod::predict(const Pose& base, double free_length, double dt) {
    trial_.base = base;
    trial_.free_length = free_length;
    if (!(dt > 0.0)) return;    // the same step again, from where it began
    if (!state_.placed) {       // no hand has moved it yet: it is put there, at rest
        trial_.dt = dt;
        for (int i = 0; i < chain_.nodes(); ++i) trial_.start[i] = trial_.coasting[i] = place(trial_, i);
        return;
    }
    trial_.dt = dt;
    for (int i = 0; i < chain_.nodes(); ++i) {
        const Vector3 velocity = state_.dt > 0.0 ? Vector3((state_.places[i] - state_.start[i]) / state_.dt) : Vector3::Zero();
        trial_.start[i] = state_.places[i];
        trial_.coasting[i] = state_.places[i] + dt * velocity;
    }
    trial_.strains = state_.bent;
}

Viscosity Rod::viscosity() const {
    const double rate = retardation_ > 0.0 && trial_.dt > 0.0 ? retardation_ / trial_.dt : 0.0;
    return {.rate = rate, .before = &trial_.strains};
}

void Rod::add_inertia(VectorX& imbalance) const {
    const Quaternion to_base = trial_.base.rotation.conjugate();
    for (int i = 1; i < chain_.nodes(); ++i) imbalance.segment<3>(Chain::unknown_of(i)) += to_base * inertia(trial_, i);
}

Linearisation Rod::linearise(ContactPoints points, double shift) {
    const double per_mass = (trial_.dt > 0.0 ? 1.0 / (trial_.dt * trial_.dt) : 0.0) + shift;
    tangent_.clear();
    chain_.linearise(trial_.shape, trial_.tensions, viscosity(), tangent_, imbalance_);
    add_inertia(imbalance_);
    for (int i = 1; i < chain_.nodes(); ++i) {
        for (int a = Chain::unknown_of(i); a < Chain::unknown_of(i) + 3; ++a) tangent_.add(a, a, per_mass * node_mass(i));
    }
    const int negatives = tangent_.factor();
    step_ = -imbalance_;
    tangent_.solve(step_);
    find_spots(points);
    solve_columns(static_cast<int>(points.size()));
    assemble(points);
    const auto rows = 3 * static_cast<Eigen::Index>(points.size());
    return {.free = {free_.data(), rows},
            .compliance = {compliance_.data(), rows, rows, Eigen::OuterStride<>(compliance_.outerStride())},
            .negatives = negatives};
}

// Sorted from the base to the tip: a column's solution is wanted from its contact on only, by symmetry.
void Rod::find_spots(ContactPoints points) {
    const auto count = static_cast<int>(points.size());
    std::iota(order_.begin(), order_.begin() + count, 0);
    std::sort(order_.begin(), order_.begin() + count, [points](int a, int b) {
        return points[a].arclength != points[b].arclength ? points[a].arclength < points[b].arclength : a < b;
    });
    for (int i = 0; i < count; ++i) spots_[i] = Spot::at(chain_, points[i].arclength);
}

void Rod::solve_columns(int count) {
    if (count == 0) return;
    const Matrix3 to_base = trial_.base.rotation.toRotationMatrix().transpose();
    const int first = Chain::unknown_of(spots_[order_[0]].first);
    columns_.block(first, 0, chain_.unknowns() - first, 3 * count).setZero();
    for (int rank = 0; rank < count; ++rank) {
        const Spot& spot = spots_[order_[rank]];
        for (int i = 0; i < spot.count; ++i)
            columns_.block<3, 3>(Chain::unknown_of(spot.first + i), 3 * rank) = spot.weights[i] * to_base;
        for (int a = 0; a < 3; ++a) starts_[3 * rank + a] = Chain::unknown_of(spot.first);
    }
    tangent_.solve(columns_, starts_, 3 * count);
}

// W = J K⁻¹ Jᵀ and the places after the step that no contact force acts in, world.
void Rod::assemble(ContactPoints points) {
    const auto count = static_cast<int>(points.size());
    const Matrix3 to_world = trial_.base.rotation.toRotationMatrix();
    for (int rank = 0; rank < count; ++rank) {
        const int i = order_[rank];
        const Spot& spot = spots_[i];
        Vector3 moved = Vector3::Zero();
        for (int n = 0; n < spot.count; ++n) moved += spot.weights[n] * step_.segment<3>(Chain::unknown_of(spot.first + n));
        free_.segment<3>(3 * i) = place(trial_, spot, points[i].arclength) + to_world * moved;
        for (int other = 0; other <= rank; ++other) {
            Matrix3 block = Matrix3::Zero();
            for (int n = 0; n < spot.count; ++n)
                block += spot.weights[n] * columns_.block<3, 3>(Chain::unknown_of(spot.first + n), 3 * other);
            const Matrix3 world = to_world * block;
            const int j = order_[other];
            compliance_.block<3, 3>(3 * i, 3 * j) = world;
            compliance_.block<3, 3>(3 * j, 3 * i) = world.transpose();
        }
    }
}

// Jᵀ λ.
void Rod::add_contacts(ContactPoints points, Forces forces, VectorX& load) const {
    const Quaternion to_base = trial_.base.rotation.conjugate();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector3 force = to_base * Vector3(forces.segment<3>(3 * static_cast<Eigen::Index>(i)));
        const Spot& spot = spots_[i];
        for (int n = 0; n < spot.count; ++n) load.segment<3>(Chain::unknown_of(spot.first + n)) += spot.weights[n] * force;
    }
}

StepReport Rod::try_step(ContactPoints points, Forces forces) {
    const double turned = advance(points, forces);
    add_up(points, forces);
    const double residual = left_over(points, forces);
    const double scale = needle_.bending_stiffness() / (needle_.length * needle_.length);    // [N]
    return {.residual = residual <= rounding() ? 0.0 : residual, .tangent_changed = !(turned <= noticeable * scale)};
}

// The Newton step under these forces. Returns the largest change of a tension [N].
double Rod::advance(ContactPoints points, Forces forces) {
    change_ = -imbalance_;
    add_contacts(points, forces, change_);
    tangent_.solve(change_);
    double turned = 0.0;
    for (int i = 0; i < chain_.edges(); ++i) {
        const double tension = chain_.tension(trial_.shape, i) + chain_.tension_change(trial_.shape, change_, i);
        turned = std::max(turned, std::abs(tension - trial_.tensions[i]));
        trial_.tensions[i] = tension;
    }
    chain_.move(change_, trial_.shape);
    return turned;
}

// What the contacts come to at the base.
void Rod::add_up(ContactPoints points, Forces forces) {
    trial_.contact_force.setZero();
    trial_.contact_moment.setZero();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector3 force = forces.segment<3>(3 * static_cast<Eigen::Index>(i));
        trial_.contact_force += force;
        trial_.contact_moment += (place(trial_, spots_[i], points[i].arclength) - trial_.base.position).cross(force);
    }
}

// [N] Largest imbalance of the trial shape; of the angles, the torque over an edge.
double Rod::left_over(ContactPoints points, Forces forces) {
    chain_.gradient(trial_.shape, {}, trial_.elastic);
    change_ = trial_.elastic;
    if (viscosity().rate > 0.0) chain_.gradient(trial_.shape, viscosity(), change_);
    add_inertia(change_);
    change_ = -change_;
    add_contacts(points, forces, change_);
    double residual = 0.0;
    for (int i = 0; i < chain_.edges(); ++i) {
        residual = std::max(
            {residual, change_.segment<3>(4 * i).cwiseAbs().maxCoeff(), std::abs(change_[4 * i + 3]) / chain_.edge_length()});
    }
    return residual;
}

// [N] What no Newton step can better: displacements and directions are rounded, and short edges are stiff.
double Rod::rounding() const {
    constexpr double roundings = 8.0 * std::numeric_limits<double>::epsilon();    // a few add up
    double largest = 0.0;                                                         // [m]
    for (const Vector3& displacement : trial_.shape.displacement) largest = std::max(largest, displacement.cwiseAbs().maxCoeff());
    const double edge = chain_.edge_length(), bending = needle_.bending_stiffness() / (edge * edge);    // [N] EI/ℓ²
    const double stretching = chain_.setup().section.stretching;
    return roundings * (1.0 + viscosity().rate) * ((stretching + bending) * largest / edge + bending);
}

double Rod::kinetic(const State& state) const {
    if (!(state.dt > 0.0)) return 0.0;
    double sum = 0.0;
    for (int i = 0; i < chain_.nodes(); ++i) sum += node_mass(i) * (place(state, i) - state.start[i]).squaredNorm();
    return 0.5 * sum / (state.dt * state.dt);
}

// [N·m] The damping's share of a joint's moments.
Vector3 Rod::viscous(int joint, const Strain& strain) const {
    const Viscosity now = viscosity();
    const Strain& before = trial_.strains[joint];
    return now.rate * chain_.bending_and_twisting(joint).cwiseProduct(strain - before);
}

EnergyReport Rod::energy() const {
    EnergyReport report = state_.energy;
    report.stored = chain_.energy(trial_.shape);
    report.kinetic = kinetic(trial_);
    if (!state_.placed) return report;
    double work = 0.0;    // [J] on masses and edges since the last commit, by trapezoids
    for (int i = 0; i < chain_.nodes(); ++i)
        work += 0.5 * (state_.inertia[i] + inertia(trial_, i)).dot(place(trial_, i) - state_.places[i]);
    for (int i = 1; i < chain_.nodes(); ++i) {
        const Vector3 moved = trial_.shape.displacement[i] - state_.shape.displacement[i];
        const int at = Chain::unknown_of(i);
        work += 0.5 * (state_.elastic.segment<3>(at) + trial_.elastic.segment<3>(at)).dot(moved);
    }
    report.numerical += work - (report.kinetic - state_.energy.kinetic) - (report.stored - state_.energy.stored);
    if (retardation_ > 0.0) {
        for (int i = 0; i < chain_.edges(); ++i) {
            const Strain now = chain_.strain(trial_.shape, i);
            report.damping += 0.5 * (state_.viscous[i] + viscous(i, now)).dot(now - state_.bent[i]);
        }
    }
    return report;
}

void Rod::commit() {
    trial_.energy = energy();
    trial_.wrench = {.force = -trial_.contact_force, .moment = -trial_.contact_moment};
    for (int i = 0; i < chain_.nodes(); ++i) {
        trial_.places[i] = place(trial_, i);
        trial_.inertia[i] = inertia(trial_, i);
        trial_.wrench.force += trial_.inertia[i];
        trial_.wrench.moment += (trial_.places[i] - trial_.base.position).cross(trial_.inertia[i]);
    }
    for (int i = 0; i < chain_.edges(); ++i) {
        trial_.bent[i] = chain_.strain(trial_.shape, i);
        if (retardation_ > 0.0) trial_.viscous[i] = viscous(i, trial_.bent[i]);
    }
    trial_.placed = true;
    const double length = std::max(trial_.free_length, needle_.radius);
    const double least = pi * pi * needle_.bending_stiffness() / (4.0 * length * length);
    const bool pressed = trial_.wrench.force.dot(trial_.base.axis()) > least;
    trial_.buckled = bow(trial_) > (state_.buckled ? straightens : bows) * length && (pressed || state_.buckled);
    state_ = trial_;
}

// [m] Largest distance of the free length from the straight line between its ends.
double Rod::bow(const State& state) const {
    const Vector3 end = state.free_length * Chain::axis + Spot::at(chain_, state.free_length).displacement(state.shape);
    const Vector3 along = end.normalized();
    double largest = 0.0;
    for (int i = 1; i * chain_.edge_length() < state.free_length; ++i) {
        const Vector3 at = i * chain_.edge_length() * Chain::axis + state.shape.displacement[i];
        largest = std::max(largest, (at - at.dot(along) * along).norm());
    }
    return largest;
}

Vector3 Rod::tangent(double arclength) const {
    const Vector3 local = Chain::axis + Spot::at(chain_, arclength).slope(trial_.shape);
    return trial_.base.rotation * Vector3(local.normalized());
}

// A bevelled tip pushes itself aside of its axis as it cuts.
Vector3 Rod::cut_direction(double length) const {
    const Vector3 along = tangent(length);
    if (cut_angle_ == 0.0) return along;
    const int last = chain_.edges() - 1;
    const Vector3 axis = trial_.base.rotation.conjugate() * along;
    const Vector3& reference = trial_.shape.reference[last];
    const Vector3 first =
        std::cos(trial_.shape.angle[last]) * reference + std::sin(trial_.shape.angle[last]) * axis.cross(reference);
    const Vector3 local = std::cos(cut_angle_) * axis + std::sin(cut_angle_) * first;
    return trial_.base.rotation * Vector3(local.normalized());
}

NeedleState Rod::state() const {
    NeedleState report{.critical_load = std::numeric_limits<double>::infinity(),
                       .axial_load = state_.wrench.force.dot(state_.base.axis()),
                       .buckled = state_.buckled};
    for (int i = 1; i < chain_.nodes(); ++i) {
        report.deflection = std::max(report.deflection, state_.shape.displacement[i].head<2>().norm());
        const Vector3 edge = chain_.edge_length() * Chain::axis + state_.shape.displacement[i] - state_.shape.displacement[i - 1];
        report.slope = std::max(report.slope, std::atan2(edge.head<2>().norm(), -edge.z()));
    }
    return report;
}

const char* Rod::beyond_validity() const {
    return state().slope > touches_itself ? "beyond validity: the needle would meet itself" : nullptr;
}

void Rod::centreline(std::span<Vector3> points) const {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double arclength = needle_.length * static_cast<double>(i) / static_cast<double>(points.size() - 1);
        points[i] = place(state_, Spot::at(chain_, arclength), arclength);
    }
}

}    // namespace stylet::rod

STYLET_PLUGIN(
    stylet::rod::Rod, "rod", stylet::rod::parameters,
    .summary = "A geometrically exact needle: it buckles, bends between layers and steers by itself",
    .formula =
        "M (x - x~)/dt^2 + dU/dx = J^T f,  x~ = x_n + dt v_n\n"
        "U = sum over edges of EA (|e| - h)^2/2h + sum over joints of [EI (k - k0)^2 + GJ m^2]/2h\n"
        "x nodes and angles, e an edge of rest length h [m], k and m the discrete curvature and twist of a joint [1], f the "
        "contact forces [N]",
    .source =
        "Bergou et al. 2008 and 2010 (discrete elastic rods); backward Euler in time. Deviation: the material's angles are "
        "unknowns and have no inertia; contacts act on a Catmull-Rom curve through the nodes",
    .validity =
        "Slender elastic needles, bends of any size until the needle would meet itself. Second order in the spacing of the "
        "nodes: Euler's load is 0.13 % low at 41 nodes. The tip is held by what it touches, whatever `ends` says of it, so "
        "clamped-clamped is refused. Leaves out shear, gravity, plastic bending and contact of the needle with itself")
