#include "rigid.h"

namespace stylet::rigid {

RigidNeedle::RigidNeedle(const Setup& setup) : length_(setup.needle->length) {}

void RigidNeedle::predict(const Pose& base, double, double) {
    trial_.base = base;
    trial_.axis = base.axis();
}

Linearisation RigidNeedle::linearise(ContactPoints points, double) {
    const auto rows = 3 * static_cast<Eigen::Index>(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) free_.segment<3>(3 * i) = position(points[i].arclength);
    // All columns of a zero matrix are the same one: an outer stride of zero spares the other 3n − 1.
    return {{free_.data(), rows}, {no_motion_.data(), rows, rows, Eigen::OuterStride<>(0)}, 0};
}

StepReport RigidNeedle::try_step(ContactPoints points, Forces forces) {
    trial_.force.setZero();
    trial_.moment.setZero();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector3 force = forces.segment<3>(3 * i);
        trial_.force += force;
        trial_.moment += (points[i].arclength * trial_.axis).cross(force);
    }
    return {};
}

NeedleState RigidNeedle::state() const {
    return {.critical_load = std::numeric_limits<double>::infinity(), .axial_load = -state_.force.dot(state_.axis)};
}

void RigidNeedle::centreline(std::span<Vector3> points) const {
    const double step = points.size() > 1 ? length_ / static_cast<double>(points.size() - 1) : 0.0;    // [m]
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i] = state_.base.position + static_cast<double>(i) * step * state_.axis;
    }
}

}    // namespace stylet::rigid

STYLET_PLUGIN(
    stylet::rigid::RigidNeedle, "rigid", stylet::no_parameters, .summary = "A needle that does not deform",
    .formula =
        "x(s) = x_base + s axis\n"
        "force on the base = -sum f_i, moment about it = -sum (x_i - x_base) x f_i",
    .source = "Newton's and Euler's balance of a massless rigid body",
    .validity =
        "Compression well below the critical load of the real needle, and side forces that bend it by less than matters. Leaves "
        "out bending, buckling, stretching, twisting, inertia and weight")
