// A straight needle, a block of tissue and an effect without mechanics: what contacts and ledger see of bodies, set by the test.
#pragma once

#include <stylet/force_model.h>
#include <stylet/needle_model.h>
#include <stylet/tissue_model.h>

namespace stylet::core {

class StraightNeedle final : public NeedleModel {
public:
    explicit StraightNeedle(double length) : length_(length) {}

    /// Puts the tip here; the needle points down.
    void put_tip(const Vector3& tip) { tip_ = tip; }
    EnergyReport report;

    [[nodiscard]] Vector3 position(double arclength) const override { return tip_ + (arclength - length_) * tangent(arclength); }
    [[nodiscard]] Vector3 tangent(double) const override { return -Vector3::UnitZ(); }
    [[nodiscard]] EnergyReport energy() const override { return report; }

    void predict(const Pose&, double, double) override {}
    Linearisation linearise(ContactPoints, double) override { return {{nullptr, 0}, {nullptr, 0, 0, Eigen::OuterStride<>(1)}}; }
    StepReport try_step(ContactPoints, Forces) override { return {}; }
    void commit() override {}
    void rollback() override {}
    [[nodiscard]] Wrench base_wrench() const override { return {}; }
    [[nodiscard]] NeedleState state() const override { return {}; }
    void centreline(std::span<Vector3>) const override {}

private:
    double length_;    // [m]
    Vector3 tip_ = Vector3::Zero();
};

/// From z = 0 down to −`bottom`; its second layer begins at −`interface`.
class StillTissue final : public TissueModel {
public:
    StillTissue(double interface, double bottom) : interface_(interface), bottom_(bottom) {}

    EnergyReport report;

    [[nodiscard]] Vector3 displacement(const Vector3&) const override { return Vector3::Zero(); }
    [[nodiscard]] Location locate(const Vector3& material) const override {
        const double depth = -material.z();
        const bool inside = depth >= 0.0 && depth <= bottom_;
        return {.layer = inside ? (depth >= interface_ ? 1 : 0) : outside, .depth = depth};
    }
    [[nodiscard]] double entry(const Vector3& from, const Vector3& to) const override {
        return from.z() > 0.0 && to.z() <= 0.0 ? from.z() / (from.z() - to.z()) : -1.0;
    }
    [[nodiscard]] EnergyReport energy() const override { return report; }

    void predict(double) override {}
    Linearisation linearise(ContactPoints, double) override { return {{nullptr, 0}, {nullptr, 0, 0, Eigen::OuterStride<>(1)}}; }
    StepReport try_step(ContactPoints, Forces) override { return {}; }
    void commit() override {}
    void rollback() override {}

private:
    double interface_, bottom_;    // [m]
};

}    // namespace stylet::core
