// Small plugins that keep the contract, except for the one flaw that their parameter `flaw` names.
#pragma once

#include <stylet/contract/contract.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>

namespace stylet::contract {

class Flaw {
public:
    explicit Flaw(const Setup& setup) : name_(setup.parameters.text("flaw")) {}
    [[nodiscard]] bool is(const char* name) const { return name_ == name; }

private:
    std::string name_;
};

template <class Plugin>
Descriptor describe() {
    static constexpr Parameter parameters[] = {text("flaw", "what it does wrong")};
    return {
        .stamp = build_stamp(),
        .role = Plugin::role,
        .parameter_count = 1,
        .name = "flawed",
        .about = {.summary = "A plugin for the contract's own tests", .formula = "none", .source = "none", .validity = "tests"},
        .parameters = parameters,
        .create = create_plugin<Plugin>};
}

inline void allocate(bool with_malloc = false) {
    void* volatile kept = with_malloc ? std::malloc(8) : ::operator new(8);    // volatile, or the optimiser removes both
    if (with_malloc) std::free(kept);
    if (!with_malloc) ::operator delete(kept);
}

/// Contacts on springs that are coupled through their mean: u = c (f + mean of f).
class FlawedTissue final : public TissueModel {
public:
    explicit FlawedTissue(const Setup& setup)
        : flaw_(setup), depth_(setup.tissue->extent.z()), half_width_(0.5 * setup.tissue->extent.x()) {
        static int made = 0;
        if (flaw_.is("differs from its twin")) softness_ *= 1.0 + 1e-15 * ++made;
    }

    void predict(double) override {
        if (flaw_.is("creeps at one instant")) trial_.shift -= 1e-6;
    }

    Linearisation linearise(ContactPoints points, double) override {
        const auto n = static_cast<Eigen::Index>(points.size());
        if (flaw_.is("allocates in linearise")) allocate();
        if (flaw_.is("allocates with malloc")) allocate(true);
        if (flaw_.is("linearise moves the state")) trial_.shift += 1e-15;
        fill(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const ContactPoint& point = points[static_cast<std::size_t>(i)];
            free_.segment<3>(3 * i) = point.material + 0.5 * point.span;
            free_[3 * i + 2] += (flaw_.is("sags") ? -1e-6 : 0.0) + trial_.shift;
        }
        return {{free_.data(), 3 * n}, {compliance_.data(), 3 * n, 3 * n, Eigen::OuterStride<>(compliance_.outerStride())}, 0};
    }

    StepReport try_step(ContactPoints points, Forces forces) override {
        const auto n = static_cast<Eigen::Index>(points.size());
        Vector3 sum = Vector3::Zero();
        for (Eigen::Index i = 0; i < n; ++i) sum += forces.segment<3>(3 * i);
        const double mean_part = n > 0 ? sum.squaredNorm() / static_cast<double>(n) : 0.0;
        trial_.energy.stored = 0.5 * softness_ * (forces.squaredNorm() + mean_part) * (flaw_.is("half the energy") ? 0.5 : 1.0);
        if (flaw_.is("overflows")) trial_.energy.stored += 1e-300 * std::exp(forces.norm());
        if (flaw_.is("damping returns")) trial_.energy.damping = forces.norm();
        if (flaw_.is("keeps a dent")) trial_.shift = std::min(trial_.shift, -1e-3 * forces.norm());
        if (flaw_.is("moves unannounced")) trial_.shift = 1e-4 * forces.norm();
        if (flaw_.is("rollback forgets the last bit")) trial_.shift = 1e-18 * forces.norm();
        return {};
    }

    void commit() override { state_ = trial_; }
    void rollback() override {
        const double shift = trial_.shift;
        trial_ = state_;
        if (flaw_.is("rollback forgets the last bit")) trial_.shift = shift;
    }
    [[nodiscard]] EnergyReport energy() const override {
        return flaw_.is("energy of the commit") ? state_.energy : trial_.energy;
    }

    [[nodiscard]] Vector3 displacement(const Vector3&) const override { return Vector3::Zero(); }
    [[nodiscard]] Location locate(const Vector3& material) const override {
        const double depth = -material.z();
        if (depth < 0.0 || depth > depth_ || std::abs(material.x()) > half_width_) return {outside, depth};
        return {flaw_.is("interface belongs above") && depth == 0.0 ? outside : 0, depth};
    }
    [[nodiscard]] double entry(const Vector3& from, const Vector3& to) const override {
        if (from.z() <= 0.0 || to.z() > 0.0) return -1.0;
        return from.z() / (from.z() - to.z()) + (flaw_.is("enters late") ? 1e-3 : 0.0);
    }
    [[nodiscard]] const char* beyond_validity() const override { return flaw_.is("always in doubt") ? "who knows" : nullptr; }

private:
    struct State {
        EnergyReport energy;
        double shift = 0.0;    // [m] of all free positions
    };

    void fill(Eigen::Index n) {
        const double own =
            softness_ * (flaw_.is("negative compliance") ? -1.0 : 1.0) * (flaw_.is("compliance 1 % off") ? 1.01 : 1.0);
        auto w = compliance_.topLeftCorner(3 * n, 3 * n);
        w.setZero();
        for (Eigen::Index i = 0; i < n; ++i) {
            for (Eigen::Index j = 0; j < n; ++j)
                w.block<3, 3>(3 * i, 3 * j).diagonal().setConstant((i == j ? own : 0.0) + own / static_cast<double>(n));
        }
        if (n > 0 && flaw_.is("asymmetric compliance")) w(0, 1) += 1e-9 * softness_;
    }

    Flaw flaw_;
    double depth_;              // [m]
    double half_width_;         // [m]
    double softness_ = 0.05;    // [m/N]
    State state_, trial_;
    VectorX free_ = VectorX::Zero(3 * max_contacts);
    MatrixX compliance_ = MatrixX::Zero(3 * max_contacts, 3 * max_contacts);
};

/// A needle that only shortens, like a spring of stiffness K/L: δ = N L/K, U = Kδ²/2L, entry force Kδ²/2L² (N its compression).
class FlawedNeedle final : public NeedleModel {
public:
    explicit FlawedNeedle(const Setup& setup) : flaw_(setup), length_(setup.needle->length) {}

    void predict(const Pose& base, double free_length, double) override {
        trial_.base = base;
        if (flaw_.is("jumps with the free length")) trial_.shortening *= free_length / trial_.free_length;
        trial_.free_length = free_length;
    }

    Linearisation linearise(ContactPoints points, double) override {
        const auto n = static_cast<Eigen::Index>(points.size());
        const Vector3 axis = trial_.base.axis();
        const double softness = trial_.free_length / stiffness * (flaw_.is("compliance 1 % off") ? 1.01 : 1.0);    // [m/N]
        for (Eigen::Index i = 0; i < n; ++i) {
            free_.segment<3>(3 * i) = trial_.base.position + points[static_cast<std::size_t>(i)].arclength * axis;
            if (flaw_.is("bends in world x")) free_[3 * i] += 1e-3 * trial_.compression;
            for (Eigen::Index j = 0; j < n; ++j) compliance_.block<3, 3>(3 * i, 3 * j) = softness * axis * axis.transpose();
        }
        return {{free_.data(), 3 * n}, {compliance_.data(), 3 * n, 3 * n, Eigen::OuterStride<>(compliance_.outerStride())}, 0};
    }

    StepReport try_step(ContactPoints points, Forces forces) override {
        const Vector3 axis = trial_.base.axis();
        trial_.force.setZero();
        trial_.moment.setZero();
        for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(points.size()); ++i) {
            const Vector3 force = forces.segment<3>(3 * i);
            trial_.force += force;
            trial_.moment += points[static_cast<std::size_t>(i)].arclength * axis.cross(force);
        }
        trial_.compression = -trial_.force.dot(axis);
        trial_.shortening = trial_.compression * trial_.free_length / stiffness;
        trial_.moment -= trial_.shortening * axis.cross(trial_.force);    // every contact moved back by as much
        return {};
    }

    void commit() override { state_ = trial_; }
    void rollback() override {
        const Pose base = trial_.base;
        trial_ = state_;
        if (flaw_.is("rollback forgets the base")) trial_.base = base;
    }
    [[nodiscard]] EnergyReport energy() const override {
        const State& state = flaw_.is("energy of the commit") ? state_ : trial_;
        const double part = flaw_.is("half the energy") ? 0.25 : 0.5;
        return {.stored =
                    state.shortening == 0.0 ? 0.0 : part * stiffness * state.shortening * state.shortening / state.free_length};
    }

    [[nodiscard]] Vector3 position(double arclength) const override {
        const double part = arclength < trial_.free_length ? arclength / trial_.free_length : 1.0;
        const double back = flaw_.is("position ignores the load") ? 0.0 : part * trial_.shortening;
        return trial_.base.position + (arclength - (arclength > 0.0 ? back : 0.0)) * trial_.base.axis();
    }
    [[nodiscard]] Vector3 tangent(double) const override {
        return (flaw_.is("tangent not unit") ? 1.001 : 1.0) * trial_.base.axis();
    }
    [[nodiscard]] double entry_force() const override {
        if (flaw_.is("no entry force")) return 0.0;
        if (trial_.shortening == 0.0 && !flaw_.is("divides by the free length")) return 0.0;
        return 0.5 * stiffness * std::pow(trial_.shortening / trial_.free_length, 2);
    }
    [[nodiscard]] Wrench base_wrench() const override {
        const State& state = reported();
        return {(flaw_.is("feels half") ? -0.5 : -1.0) * state.force, (flaw_.is("no moment") ? 0.0 : -1.0) * state.moment};
    }
    [[nodiscard]] NeedleState state() const override {
        return {.critical_load = 1.0, .axial_load = reported().compression, .deflection = flaw_.is("starts bent") ? 0.01 : 0.0};
    }
    void centreline(std::span<Vector3> points) const override {
        const double spacing = (length_ - state_.shortening) / static_cast<double>(points.size() - 1);
        for (std::size_t i = 0; i < points.size(); ++i)
            points[i] = state_.base.position + static_cast<double>(i) * spacing * state_.base.axis();
    }

private:
    static constexpr double stiffness = 20.0;    // [N] K

    struct State {
        Pose base;
        double free_length = 0.0;    // [m]
        double shortening = 0.0;     // [m]
        double compression = 0.0;    // [N]
        Vector3 force = Vector3::Zero();
        Vector3 moment = Vector3::Zero();
    };

    [[nodiscard]] const State& reported() const { return flaw_.is("reports the trial") ? trial_ : state_; }

    Flaw flaw_;
    double length_;    // [m]
    State state_, trial_;
    VectorX free_ = VectorX::Zero(3 * max_contacts);
    MatrixX compliance_ = MatrixX::Zero(3 * max_contacts, 3 * max_contacts);
};

/// A column whose load falls with the square of its length, like Euler's.
class FlawedBuckling final : public BucklingModel {
public:
    explicit FlawedBuckling(const Setup& setup) : flaw_(setup) {}

    [[nodiscard]] double critical_load(const Column& column) const override {
        static constexpr std::array factors{2.5, 9.9, 20.2, 39.5};
        if (flaw_.is("allocates")) allocate();
        const double length = flaw_.is("not capped") ? column.free_length : std::max(column.free_length, column.radius);
        const double stiffness = flaw_.is("stiffness ignored") ? 1.0 : column.bending_stiffness;
        const auto ends = static_cast<std::size_t>(column.ends);
        double load = factors[flaw_.is("ends mixed up") ? 3 - ends : ends] * stiffness / (length * length);
        if (flaw_.is("divides by the depth")) load *= column.depth / column.inserted;
        if (flaw_.is("tissue weakens") && column.inserted > 0.0) load *= std::pow(length / column.length(), 3);
        if (flaw_.is("longer is stronger")) load = stiffness * (1.0 + length);
        if (flaw_.is("remembers")) load += std::exchange(last_, load);
        return load;
    }

private:
    Flaw flaw_;
    mutable double last_ = 0.0;    // [N]
};

/// Friction on the shaft, a limit at the tip, and a price for every cut.
class FlawedEffect final : public ForceModel {
public:
    explicit FlawedEffect(const Setup& setup) : flaw_(setup) {}

    void add_to(const Contact& contact, ContactLaw& law) const override {
        if (flaw_.is("allocates")) allocate();
        if (flaw_.is("multiplies")) law.axial_limit *= 1.5;
        if (flaw_.is("pushes along the slip")) law.own_force += std::copysign(0.5, contact.slip) * contact.axis;
        if (contact.tip) law.add_tip(contact.inside ? 0.3 : 1.0);
        if (contact.tip && flaw_.is("unlimits the tip")) law.tip_limited = false;
        if (!contact.tip) law.add_axial(limit(contact));
    }

    double settle(const Settlement& change) override {
        if (flaw_.is("pays for the square")) return 100.0 * change.cut * change.cut;
        return (flaw_.is("pays back") ? -0.3 : 0.3) * change.cut;
    }

private:
    [[nodiscard]] double limit(const Contact& contact) const {
        if (flaw_.is("negative limit") && contact.slipping) return -1.0;
        if (flaw_.is("infinite limit")) return 1.0 / contact.coverage;
        return 5.0 * contact.coverage + (flaw_.is("counts its calls") ? 1e-9 * ++calls_ : 0.0);
    }

    Flaw flaw_;
    mutable int calls_ = 0;
};

/// A hand that sinks by 10 mm in two seconds and stays there.
class FlawedDevice final : public HapticDevice {
public:
    explicit FlawedDevice(const Setup& setup) : flaw_(setup) {
        static int made = 0;
        twin_ = 1e-15 * ++made;
    }

    [[nodiscard]] DeviceLimits limits() const override {
        return {.force = 8.5,
                .moment = flaw_.is("no moment limit") ? 0.0 : 0.5,
                .force_rate = 800.0,
                .soft_start = 0.2,
                .stale_after = 0.01,
                .ramp_down = 0.02};
    }
    [[nodiscard]] Reading read(double time) override {
        const double way = std::clamp(time, 0.0, duration());
        Pose pose{Vector3(0.0, 0.0, 0.2 - 5e-3 * way), Quaternion::Identity()};
        if (flaw_.is("not unit")) pose.rotation.w() = 1.0 + 1e-9;
        if (flaw_.is("nowhere at the end") && time >= duration()) pose.position.x() = std::nan("");
        if (flaw_.is("differs from its twin")) pose.position.x() = twin_;
        return {.pose = pose, .age = flaw_.is("heard of it tomorrow") ? -1e-3 : 0.0};
    }
    void write(const Wrench&) override {
        if (flaw_.is("allocates in write")) allocate();
    }
    [[nodiscard]] double duration() const override { return 2.0; }

private:
    Flaw flaw_;
    double twin_ = 0.0;    // [m]
};

}    // namespace stylet::contract
