#pragma once

#include "core/contacts/contacts.h"
#include "core/coupling/coupling.h"
#include "core/device/force_chain.h"
#include "core/device/passivity_observer.h"
#include "core/ledger/ledger.h"
#include "core/loading/cast.h"
#include "core/run/patch_loads.h"
#include "core/run/report.h"
#include "core/run/sample.h"
#include "core/scene/scene.h"

#include <algorithm>
#include <array>
#include <span>

namespace stylet::core {

/// What happened, and how it felt just then.
struct Event {
    const char* name = "";         // text that lives as long as the cast
    double time = 0.0;             // [s]
    double travel = 0.0;           // [m]
    double depth = 0.0;            // [m]
    double hand_force = 0.0;       // [N] before whatever the event set off
    double critical_load = 0.0;    // [N]
};

/// The events of one tick. Where a tick brings more than there is room for, the last place takes the latest: a fault is never
/// lost.
class EventList {
public:
    void clear() { count_ = 0; }
    void add(const Event& event) {
        count_ = std::min(count_ + 1, events_.size());
        events_[count_ - 1] = event;
    }
    [[nodiscard]] std::span<const Event> list() const { return {events_.data(), count_}; }

private:
    std::array<Event, 16> events_;
    std::size_t count_ = 0;
};

/// A scene in motion: one call of tick() is one time step, on whatever clock the caller keeps. Allocates nothing once made.
class Simulation {
public:
    /// Both must outlive it. Throws Error where the scene's contact spacing asks for too many contacts.
    Simulation(const Scene& scene, const Cast& cast);

    /// `held` [s] is how long the device has held the last force: the time step, unless a real-time loop was late. A force that
    /// was held for too long is a stale one.
    void tick(double held);
    void tick() { tick(dt_); }

    /// Instead of a tick, once the scene is over: takes the force from the hand. True while there is some left.
    [[nodiscard]] bool let_go();

    [[nodiscard]] double time() const { return time_; }    // [s] at the end of the last tick
    [[nodiscard]] const Sample& sample() const { return sample_; }
    [[nodiscard]] std::span<const Event> events() const { return events_.list(); }    // of the last tick
    [[nodiscard]] const Ledger& ledger() const { return ledger_; }
    [[nodiscard]] const ForceChainCounts& force_chain() const { return chain_.counts(); }
    [[nodiscard]] const PassivityObserver& passivity() const { return observer_; }
    [[nodiscard]] const PatchLoads& loads() const { return loads_; }
    [[nodiscard]] const TissueModel& tissue() const { return tissue_; }
    [[nodiscard]] const NeedleModel& needle() const { return needle_; }

    /// Of the last step, with the forces that came out; nullptr where the last tick found no equilibrium, and after a fault.
    [[nodiscard]] const ContactSet* contacts() const { return lost_ || faulted() ? nullptr : &set_; }
    [[nodiscard]] bool ever_touched() const { return ever_touched_; }
    [[nodiscard]] bool ever_punctured() const { return ever_punctured_; }
    [[nodiscard]] bool lost() const { return lost_; }    // the last tick found no equilibrium
    [[nodiscard]] bool faulted() const { return chain_.faulted(); }

private:
    bool move_to(const Pose& target, double dt, int halvings);
    bool step(const Pose& target, double dt, double most_advance);
    bool run_on();
    void begin(const Pose& first);
    void take(const Reading& hand);
    void follow(const Pose& target);
    void close(const Pose& target, const CouplingReport& report, StepCosts costs, bool at_rest);
    void announce();
    void announce_validity(const char* beyond, const char*& announced);
    void raise(const char* name);
    void fault(const char* name);
    void take_sample(const Pose& before, const Balance& books_before);
    void sample_loads();
    void write_to_device(const Wrench& out);
    [[nodiscard]] Wrench felt() const;

    const NeedleSetup setup_;
    double dt_;         // [s]
    double spacing_;    // [m]
    TissueModel& tissue_;
    NeedleModel& needle_;
    HapticDevice& device_;
    Effects effects_;
    PatchLoads loads_;

    Contacts contacts_;
    ContactSet set_;
    Coupling coupling_;
    Ledger ledger_;
    ForceChain chain_;
    PassivityObserver observer_;
    double stale_after_;    // [s]
    EventList events_;
    Sample sample_;

    std::size_t ticks_ = 0;
    double time_ = 0.0;      // [s]
    double now_ = 0.0;       // [s] of the last commit, within the tick
    double travel_ = 0.0;    // [m]
    bool begun_ = false;     // the very first step found where needle and tissue are; until then a tissue's clock stands still
    Pose base_;
    double imbalance_ = 0.0;    // of the last step at rest, as a share of what is allowed
    bool held_back_ = false;    // the last step's tip had further to go at rest of the hand
    bool lost_ = false;         // the last tick found no equilibrium
    bool hand_lost_ = false;    // the device's last reading was stale
    bool buckled_ = false;
    int bucklings_ = 0;
    bool ever_touched_ = false;
    bool ever_punctured_ = false;
    bool base_at_tissue_ = false;
    int astray_ = 0;    // ticks in which the tip is in the tissue, but no contact knows of it
    const char* needle_beyond_ = nullptr;
    const char* tissue_beyond_ = nullptr;
};

}    // namespace stylet::core
