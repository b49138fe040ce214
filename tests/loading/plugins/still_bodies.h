// Bodies that do nothing, for tests of what happens around them.
#pragma once

#include <stylet/needle_model.h>
#include <stylet/tissue_model.h>

namespace stylet::still {

/// Both kinds of body answer core's questions alike.
template <class Role>
class Body : public Role {
public:
    Linearisation linearise(ContactPoints, double) override {
        return {{nullptr, 0}, {nullptr, 0, 0, Eigen::OuterStride<>(1)}, 0};
    }
    StepReport try_step(ContactPoints, Forces) override { return {}; }
    void commit() override {}
    void rollback() override {}
    EnergyReport energy() const override { return {}; }
};

class Tissue : public Body<TissueModel> {
public:
    explicit Tissue(const Setup& setup) : layers_(setup.tissue->layers) {}
    void predict(double) override {}
    Vector3 displacement(const Vector3&) const override { return Vector3::Zero(); }
    Location locate(const Vector3& material) const override { return {0, -material.z()}; }
    double entry(const Vector3&, const Vector3&) const override { return static_cast<double>(layers_.size()); }

private:
    std::vector<Layer> layers_;
};

class Needle : public Body<NeedleModel> {
public:
    explicit Needle(const Setup& setup) : length_(setup.needle->length) {}
    void predict(const Pose&, double, double) override {}
    Vector3 position(double arclength) const override { return {0.0, 0.0, -arclength}; }
    Vector3 tangent(double) const override { return {0.0, 0.0, -1.0}; }
    Wrench base_wrench() const override { return {}; }
    NeedleState state() const override { return {.critical_load = critical_load_}; }
    void centreline(std::span<Vector3> points) const override { points.back() = position(length_); }

protected:
    double critical_load_ = 0.0;

private:
    double length_;
};

}    // namespace stylet::still
