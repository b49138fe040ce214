#include "rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace stylet::contract {
namespace {

constexpr double balance = 1e-9;            // [N] the coupling's own tolerance
constexpr int most_iterations = 100;        // a Newton step per branch and a few to close in takes ten
constexpr double contact_spacing = 5e-3;    // [m] that of the prepared scenes
constexpr double shaft_share = 0.1;         // of the tip's load, on each shaft contact

/// A base that is tilted, turned and away from the origin, so that no axis is special; it aims at the origin.
Pose tilted_base(double free_length) {
    const Quaternion rotation(Eigen::AngleAxisd(0.4, Vector3(1.0, 2.0, 0.5).normalized()));
    Pose base{Vector3::Zero(), rotation};
    base.position = -free_length * base.axis();
    return base;
}

}    // namespace

bool Rig::converge(const VectorX& forces) const {
    for (int i = 0; i < most_iterations; ++i) {
        (void)body->linearise(points, 0.0);
        const StepReport report = body->try_step(points, view(forces));
        if (report.residual <= balance && !report.tangent_changed) return true;
    }
    return false;
}

bool Rig::advance(const VectorX& forces) const {
    predict();
    const bool balanced = converge(forces);
    body->commit();
    return balanced;
}

VectorX Rig::positions(const VectorX& forces) const {
    const Linearisation found = body->linearise(points, 0.0);
    return found.free + found.compliance * forces;
}

Rig make_rig(const Descriptor& plugin, const Case& with, double depth, double spacing) {
    Rig rig;
    rig.object = make(plugin, with);
    const bool is_needle = plugin.role == Role::needle;
    if (is_needle) rig.needle = static_cast<NeedleModel*>(rig.object.get());
    if (!is_needle) rig.tissue = static_cast<TissueModel*>(rig.object.get());
    rig.body = is_needle ? static_cast<Body*>(rig.needle) : rig.tissue;
    rig.dt = with.dt;
    rig.length = with.needle.length;
    rig.free_length = with.needle.length - depth;
    if (is_needle) rig.base = tilted_base(rig.free_length);
    rig.axis = rig.base.axis();

    const int pieces = static_cast<int>(std::ceil(depth / spacing - 1e-9));
    for (int i = 0; i < pieces; ++i) {
        const double from = i * spacing;
        const double until = std::min(from + spacing, depth);
        rig.points.push_back({from * rig.axis, (until - from) * rig.axis, rig.free_length + 0.5 * (from + until), false});
    }
    rig.points.push_back({depth * rig.axis, Vector3::Zero(), with.needle.length, true});

    const Vector3 side = rig.base.bow_direction();
    const Vector3 force = with.load * (-rig.axis + with.lateral * side) * (is_needle ? 1.0 : -1.0);    // λ is the needle's
    rig.load.resize(3 * rig.points.size());
    for (std::size_t i = 0; i < rig.points.size(); ++i)
        rig.load.segment<3>(3 * i) = (rig.points[i].tip ? 1.0 : shaft_share) * force;
    return rig;
}

void at_both_depths(const Descriptor& plugin, const Case& with, const std::function<void(Rig&)>& check) {
    for (const double depth : {0.0, with.depth}) {
        SCOPED_TRACE("the tip is " + std::to_string(1e3 * depth) + " mm deep");
        Rig rig = make_rig(plugin, with, depth, contact_spacing);
        rig.predict();
        rig.body->commit();
        check(rig);
    }
}

std::vector<double> answers(const Rig& rig) {
    std::vector<double> all;
    const auto add = [&all](const auto& vector) { all.insert(all.end(), vector.begin(), vector.end()); };
    const Linearisation found = rig.body->linearise(rig.points, 0.0);
    add(VectorX(found.free));
    add(MatrixX(found.compliance).reshaped());
    const EnergyReport energy = rig.body->energy();
    add(std::vector{static_cast<double>(found.negatives), energy.stored, energy.kinetic, energy.damping, energy.numerical});
    if (rig.needle == nullptr) return all;
    for (const ContactPoint& point : rig.points) {
        add(rig.needle->position(point.arclength));
        add(rig.needle->tangent(point.arclength));
    }
    const Wrench wrench = rig.needle->base_wrench();
    const NeedleState state = rig.needle->state();
    add(wrench.force);
    add(wrench.moment);
    add(std::vector{rig.needle->entry_force(), std::min(state.critical_load, std::numeric_limits<double>::max()),
                    state.axial_load, state.deflection, state.slope, state.buckled ? 1.0 : 0.0});
    std::vector<Vector3> line(9);
    rig.needle->centreline(line);
    for (const Vector3& point : line) add(point);
    return all;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

bool all_finite(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

}    // namespace stylet::contract
