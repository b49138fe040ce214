// What stands in for a part that a scene doesn't name. Each does what nothing does.
#pragma once

#include <stylet/haptic_device.h>
#include <stylet/needle_model.h>
#include <stylet/tissue_model.h>

#include <algorithm>
#include <limits>

namespace stylet::core {

/// A scene without a tissue. The one contact there can be is the tip of a needle that is alone: whatever holds it is rigid, but
/// for so much that a force which no needle would yield to is still determined.
class Air final : public TissueModel {
public:
    static constexpr double give = 1e-9;    // [m/N] a thousandth of what a steel needle yields along its axis

    void predict(double) override {}
    Linearisation linearise(ContactPoints points, double) override {
        const auto rows = 3 * static_cast<Eigen::Index>(points.size());
        if (rows > 0) free_ = points.front().material;
        return {{free_.data(), rows}, {compliance_.data(), rows, rows, Eigen::OuterStride<>(3)}};
    }
    StepReport try_step(ContactPoints, Forces forces) override {
        trial_ = 0.5 * give * forces.squaredNorm();
        return {};
    }
    void commit() override { stored_ = trial_; }
    void rollback() override { trial_ = stored_; }
    [[nodiscard]] EnergyReport energy() const override { return {.stored = trial_}; }
    void bear(std::span<const Patch> patches) override {
        if (!patches.empty()) throw Error("loads a patch of the tissue, and the scene has no tissue");
    }
    [[nodiscard]] Vector3 displacement(const Vector3&) const override { return Vector3::Zero(); }
    [[nodiscard]] Location locate(const Vector3& material) const override { return {.layer = outside, .depth = -material.z()}; }
    [[nodiscard]] double entry(const Vector3&, const Vector3&) const override { return -1.0; }

private:
    Vector3 free_ = Vector3::Zero();    // [m]
    Matrix3 compliance_ = give * Matrix3::Identity();
    double trial_ = 0.0, stored_ = 0.0;    // [J]
};

/// A scene without a needle: a point far above the tissue, that nothing acts on.
class NoNeedle final : public NeedleModel {
public:
    void predict(const Pose& base, double, double) override { base_ = base.position; }
    Linearisation linearise(ContactPoints, double) override {
        return {{nullptr, 0}, {nullptr, 0, 0, Eigen::OuterStride<>(1)}};    // it has no contacts
    }
    StepReport try_step(ContactPoints, Forces) override { return {}; }
    void commit() override {}
    void rollback() override {}
    [[nodiscard]] EnergyReport energy() const override { return {}; }
    [[nodiscard]] Vector3 position(double) const override { return base_; }
    [[nodiscard]] Vector3 tangent(double) const override { return {0.0, 0.0, -1.0}; }
    [[nodiscard]] Wrench base_wrench() const override { return {}; }
    [[nodiscard]] NeedleState state() const override { return {.critical_load = std::numeric_limits<double>::infinity()}; }
    void centreline(std::span<Vector3> points) const override { std::ranges::fill(points, base_); }

private:
    Vector3 base_ = Vector3::Zero();    // [m]
};

/// A scene without a device: the base is held still above the origin, where the tip of the unloaded needle then is.
class StillHand final : public HapticDevice {
public:
    static constexpr double out_of_the_way = 1.0;    // [m] where there is no needle either

    /// `height` [m] of the base.
    explicit StillHand(double height) : base_{.position = {0.0, 0.0, height}} {}

    [[nodiscard]] DeviceLimits limits() const override {    // nobody is there to be hurt
        constexpr double none = std::numeric_limits<double>::max();
        return {.force = none, .moment = none, .force_rate = none, .soft_start = 0.0, .stale_after = none, .ramp_down = 0.0};
    }
    [[nodiscard]] Reading read(double) override { return {.pose = base_}; }
    void write(const Wrench&) override {}

private:
    Pose base_;
};

}    // namespace stylet::core
