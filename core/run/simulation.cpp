#include "core/run/simulation.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <utility>

namespace stylet::core {

namespace {

constexpr int most_halvings = 6;             // of a hand that moves the tip too far
constexpr int most_halvings_refused = 10;    // of a step that finds no equilibrium: a needle that a jump hits like a hammer
// A rupture runs on at rest of the hand in pieces of at most one contact spacing, so that friction acts during the jump. A piece
// whose books don't close to this part of the peak work (a bowed needle that snaps straight within it) is taken again at a
// quarter.
constexpr double run_on_imbalance = 6e-6;
constexpr double smallest_piece = 1.0 / 1024.0;    // of the spacing
constexpr int most_pieces = 5000;
constexpr double quiet = 1e-6;    // of the spacing: a tip that ran on by less has stopped

Pose between(const Pose& a, const Pose& b, double fraction) {
    return {.position = a.position + fraction * (b.position - a.position), .rotation = a.rotation.slerp(fraction, b.rotation)};
}

// [m] No hand is further from the tissue: a number that large is a device gone wrong, and its square would overflow.
constexpr double farthest = 1e3;
// A needle that begins in the tissue is brought in in this many moves, each halved as any other that is too far.
constexpr int steps_in = 64;
// What then still moves comes to rest in steps so long that inertia has no say.
constexpr int rests = 8;
constexpr double rest = 1.0;    // [s]

bool moves(const EnergyReport& energy) {
    constexpr double hardly = 1e-9;    // of what is stored
    return energy.kinetic > hardly * energy.stored;
}

bool makes_sense(const Pose& pose) {
    return pose.finite() && pose.position.cwiseAbs().maxCoeff() < farthest;
}

}    // namespace

Simulation::Simulation(const Scene& scene, const Cast& cast)
    : setup_(scene.needle_setup.value_or(NeedleSetup{})),
      dt_(scene.run.dt()),
      spacing_(scene.contact_spacing),
      tissue_(cast.tissue()),
      needle_(cast.needle()),
      device_(cast.device()),
      effects_(cast.effects()),
      loads_(cast.effects(), cast.tissue()),
      contacts_(scene.tissue || !scene.needle ? Contacts(setup_.length, setup_.radius, spacing_) : Contacts(setup_)),
      chain_(device_.limits(), scene.force_limit),
      stale_after_(device_.limits().stale_after) {
    try {
        begin(device_.read(0.0).pose);
    } catch (...) {
        fault("fault: a plugin threw an exception");
    }
    try {
        ledger_.open(needle_, tissue_);
        sample_.depth = tissue_.locate(needle_.position(setup_.length)).depth;
        sample_.free_length = contacts_.free_length();
        sample_.critical_load = needle_.state().critical_load;
        if (scene.needle && loads_.count() > 0) raise("beyond validity: a loaded surface is touched where it was unloaded");
    } catch (...) {
        fault("fault: a plugin threw an exception");
    }
}

// A tip that begins in the tissue is brought there the way it would have come, before the books are opened.
void Simulation::begin(const Pose& first) {
    if (!makes_sense(first)) {
        fault("fault: the device's pose is not finite");
        return;
    }
    base_ = first;
    now_ = -2.0 * steps_in * dt_ - rests * rest;    // no prescribed load acts before time 0
    needle_.predict(first, setup_.length, dt_);
    if (tissue_.locate(needle_.held_position(setup_.length)).layer != outside) {
        base_.position -= setup_.length * first.axis();
        travel_ = -setup_.length;
    }
    lost_ = !step(base_, dt_, spacing_);
    begun_ = true;
    for (int i = 1; i <= steps_in && !lost_ && base_.position != first.position; ++i) {
        lost_ = !move_to(between(base_, first, 1.0 / (steps_in + 1 - i)), dt_, 0);
    }
    for (int i = 0; i < rests && !lost_ && moves(needle_.energy()); ++i) lost_ = !move_to(base_, rest, 0);
    travel_ = 0.0;
    now_ = 0.0;
    if (lost_) raise("not converged");
}

void Simulation::tick(double held) {
    if (ticks_ > 0) events_.clear();    // what the very first contact at rest brought belongs to the first tick
    time_ = static_cast<double>(++ticks_) * dt_;
    sample_.time = time_;
    Wrench asked;
    try {    // a plugin may not throw here, but if it does the hand must not feel it
        take(device_.read(time_));
        asked = felt();
    } catch (...) {
        fault("fault: a plugin threw an exception");
    }
    if (!asked.finite()) fault("fault: the simulation's force is not finite");
    const bool stale = lost_ || hand_lost_ || held > dt_ + stale_after_;
    write_to_device(chain_.limit(asked, stale, stale ? std::max(held, dt_) : dt_));
}

bool Simulation::let_go() {
    write_to_device(chain_.let_go(dt_));
    return chain_.holds();
}

// A hand that was lost stays where it was last seen.
void Simulation::take(const Reading& hand) {
    const bool lost = !(hand.age <= stale_after_);
    if (lost && !hand_lost_) raise("hand lost");
    if (!lost && hand_lost_) raise("hand found");
    hand_lost_ = lost;
    const Pose& pose = lost ? base_ : hand.pose;
    if (makes_sense(pose)) observer_.moved(pose);
    follow(pose);
}

void Simulation::follow(const Pose& target) {
    const Pose before = base_;
    const Balance books_before = ledger_.balance();
    if (!makes_sense(target)) {
        fault("fault: the device's pose is not finite");
    } else if (!chain_.faulted()) {
        const bool found = move_to(target, dt_, 0);
        if (!found && !lost_) raise("not converged");
        lost_ = !found;
        now_ = time_;
        announce();
    }
    if (!std::isfinite(ledger_.balance().residual())) fault("fault: the energy books are not finite");
    if (!chain_.faulted()) take_sample(before, books_before);    // else the last good sample stands
}

// A step that finds no equilibrium is taken in halves, and so is a hand that moves the tip by more than a contact spacing.
bool Simulation::move_to(const Pose& target, double dt, int halvings) {
    const double turned = base_.rotation.angularDistance(target.rotation);
    const double moved = (target.position - base_.position).norm() + turned * setup_.length;
    const bool too_far = moved > spacing_ && halvings < most_halvings;
    if (!too_far && step(target, dt, spacing_)) {
        return run_on();
    }
    if (halvings == most_halvings_refused) return false;
    return move_to(between(base_, target, 0.5), 0.5 * dt, halvings + 1) && move_to(target, 0.5 * dt, halvings + 1);
}

bool Simulation::step(const Pose& target, double dt, double most_advance) {
    contacts_.remember(needle_);
    needle_.predict(target, contacts_.free_length(), dt);
    contacts_.arrange(needle_, tissue_, effects_, now_ + dt, set_);
    StepCosts costs{.relocation = coupling_.carry(tissue_, set_)};
    loads_.note_carried();
    loads_.apply(now_ + dt);
    tissue_.predict(begun_ ? dt : 0.0);
    const CouplingReport report = coupling_.solve(needle_, tissue_, set_, contacts_.mouth(), most_advance, dt);
    // Slip at the mouth of the track has changed the free length: a bowed needle's energy with it, in this step's books.
    needle_.predict(target, contacts_.free_length_after(set_), 0.0);
    costs.loads = loads_.work();
    costs.relocation -= loads_.work_carried();
    const bool at_rest = dt == 0.0;
    if (at_rest) {
        const double allowed = std::max(run_on_imbalance * ledger_.peak_work(), std::numeric_limits<double>::min());
        imbalance_ = std::abs(ledger_.imbalance_at_rest(set_, costs, needle_, tissue_)) / allowed;
    }
    const bool sloppy = at_rest && most_advance > smallest_piece * spacing_ && !(imbalance_ <= 1.0);
    if (!report.converged || sloppy) {
        needle_.rollback();
        tissue_.rollback();
        return false;
    }
    close(target, report, costs, at_rest);
    now_ += dt;
    return true;
}

// After a rupture the tip runs on while the hand hardly moves: solved again at the same instant until it stops.
bool Simulation::run_on() {
    double piece = spacing_;
    for (int i = 0; held_back_ && i < most_pieces; ++i) {
        const bool taken = step(base_, 0.0, piece);
        if (!taken && piece <= smallest_piece * spacing_) break;
        // The imbalance goes with the square of the piece: aim a little below what is allowed.
        const double change =
            std::isfinite(imbalance_) ? std::clamp(0.8 / std::sqrt(std::max(imbalance_, 1e-3)), 0.25, 2.0) : 0.25;
        piece = std::clamp(piece * (taken ? change : std::min(change, 0.5)), smallest_piece * spacing_, spacing_);
    }
    return !std::exchange(held_back_, false);
}

void Simulation::close(const Pose& target, const CouplingReport& report, StepCosts costs, bool at_rest) {
    HandStep hand{.before = base_, .after = target, .wrench_before = needle_.base_wrench(), .wrench_after = {}};
    needle_.commit();
    tissue_.commit();
    coupling_.commit();
    loads_.commit();
    hand.wrench_after = needle_.base_wrench();
    travel_ += (target.position - base_.position).dot(base_.axis());
    base_ = target;

    const ContactChange change = contacts_.absorb(needle_, tissue_, set_);
    if (change.punctured || change.cut > 0.0) {
        const Settlement settlement{
            .punctured = change.punctured, .cut = change.cut, .layer = change.layer, .needle_radius = setup_.radius};
        for (const auto& effect : effects_) costs.fracture += effect->settle(settlement);
    }
    ledger_.close(hand, set_, costs, needle_, tissue_);
    const bool ran_on = at_rest && !set_.empty() && set_.rows.front().advance > quiet * spacing_;
    held_back_ = change.punctured || report.held_back || ran_on;
    if (change.event != nullptr) raise(change.event);
    ever_punctured_ = ever_punctured_ || change.punctured;
}

// What the tick came to. In the middle of a rupture the forces are not in equilibrium, so nothing is announced there.
void Simulation::announce() {
    ever_touched_ = ever_touched_ || contacts_.tip() != TipState::free;
    const bool buckled = needle_.state().buckled;
    if (buckled && !buckled_) raise(bucklings_++ == 0 ? "buckled" : bucklings_ == 2 ? "second buckling" : "buckled again");
    if (!buckled && buckled_) raise("straightened");
    buckled_ = buckled;
    const bool inside = contacts_.tip() == TipState::inside;
    if (const bool at_tissue = inside && contacts_.free_length() <= 0.0; at_tissue != base_at_tissue_) {
        if (at_tissue) raise("base at the tissue");
        base_at_tissue_ = at_tissue;
    }
    const bool astray =
        contacts_.tip() == TipState::free && tissue_.locate(needle_.held_position(setup_.length)).layer != outside;
    astray_ = astray ? astray_ + 1 : 0;    // the tick in which a tip leaves its track doesn't count
    if (astray_ == 2) raise("in the tissue, but not through its surface");
    announce_validity(needle_.beyond_validity(), needle_beyond_);
    announce_validity(tissue_.beyond_validity(), tissue_beyond_);
}

void Simulation::announce_validity(const char* beyond, const char*& announced) {
    if (beyond != nullptr && beyond != announced) raise(beyond);
    announced = beyond;
}

// Says it without asking a plugin anything, for a plugin may be what is at fault.
void Simulation::fault(const char* name) {
    if (!chain_.faulted()) {
        events_.add({.name = name,
                     .time = time_,
                     .travel = travel_,
                     .depth = sample_.depth,
                     .hand_force = sample_.hand_force,
                     .critical_load = sample_.critical_load});
    }
    chain_.trip();
}

void Simulation::raise(const char* name) {
    events_.add({.name = name,
                 .time = time_,
                 .travel = travel_,
                 .depth = tissue_.locate(needle_.position(setup_.length)).depth,
                 .hand_force = needle_.base_wrench().force.dot(base_.axis()),
                 .critical_load = needle_.state().critical_load});
}

void Simulation::take_sample(const Pose& before, const Balance& books_before) {
    const Balance& books = ledger_.balance();
    const NeedleState state = needle_.state();
    const double moved = (base_.position - before.position).dot(before.axis());
    sample_.travel = travel_;
    sample_.depth = tissue_.locate(needle_.position(setup_.length)).depth;
    sample_.inserted = contacts_.inserted();
    sample_.hand_force = needle_.base_wrench().force.dot(base_.axis());
    if (!lost_) {    // else the rows are of a step that was taken back
        sample_.tip_force = 0.0;
        sample_.friction_force = 0.0;
        for (std::size_t i = 0; i < set_.rows.size(); ++i) {
            (set_.points[i].tip ? sample_.tip_force : sample_.friction_force) += set_.rows[i].axial_force;
        }
    }
    sample_.critical_load = state.critical_load;
    sample_.deflection = state.deflection;
    sample_.free_length = contacts_.free_length();
    sample_.contacts = contacts_.shaft_contacts();
    if (moved != 0.0) {    // at rest of the hand Eq. (7) says nothing: the last answer stands
        const double stored = books.stored - books_before.stored;
        const double fracture = books.fracture - books_before.fracture;
        sample_.energy_force =
            (books.accounted() - books.load_work - (books_before.accounted() - books_before.load_work)) / moved;
        sample_.energy_force_printed = (stored + fracture) / moved;
    }
    sample_loads();
    sample_.port_energy = observer_.energy();
    sample_.hand_work = books.hand_work;
    sample_.load_work = books.load_work;
    sample_.stored = books.stored;
    sample_.kinetic = books.kinetic;
    sample_.fracture = books.fracture;
    sample_.friction = books.friction;
    sample_.burst = books.burst;
    sample_.released = books.released;
    sample_.damping = books.damping;
    sample_.numerical = books.numerical;
    sample_.residual = books.residual();
}

// Where several patches are loaded: the mean of their ways along their forces, each weighed by its force.
void Simulation::sample_loads() {
    double force = 0.0, moment = 0.0;    // [N], [N·m]
    for (int i = 0; i < loads_.count(); ++i) {
        force += loads_.force(i).norm();
        moment += loads_.force(i).dot(loads_.displacement(i));
    }
    sample_.patch_displacement = force > 0.0 ? moment / force : 0.0;
}

// The hand feels the opposite of what it does to the needle.
Wrench Simulation::felt() const {
    if (lost_ || chain_.faulted()) return {};    // the needle's answer is of a step that was taken back, or of no use
    const Wrench held = needle_.base_wrench();
    return {.force = -held.force, .moment = -held.moment};
}

// Whatever has become of the others, the device is told: no force stands because a plugin threw.
void Simulation::write_to_device(const Wrench& out) {
    try {
        device_.write(out);
    } catch (...) {
        fault("fault: a plugin threw an exception");
    }
    observer_.wrote(out);
    sample_.device_force = -out.force.dot(base_.axis());
}

}    // namespace stylet::core
