#include "chain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stylet::rod {

namespace {

const Vector3 base_director(1.0, 0.0, 0.0);    // of the base's own edge: the direction in which a needle bows

// What `v` across `from` becomes when `from` turns to `to` by the shortest way.
Vector3 transported(const Vector3& v, const Vector3& from, const Vector3& to) {
    constexpr double opposite = 1e-12;    // a way that is not unique is as good as any
    const Vector3 moved = v - v.dot(to) / std::max(1.0 + from.dot(to), opposite) * (from + to);
    return (moved - moved.dot(to) * to).normalized();
}

}    // namespace

const Vector3 Chain::axis(0.0, 0.0, -1.0);

Chain::Chain(const ChainSetup& setup) : setup_(setup), edge_length_(setup.length / setup.edges) {}

Shape Chain::straight() const {
    return {.displacement = std::vector<Vector3>(nodes(), Vector3::Zero()),
            .angle = std::vector<double>(edges(), 0.0),
            .reference = std::vector<Vector3>(edges(), base_director),
            .reference_twist = std::vector<double>(edges(), 0.0)};
}

Edge Chain::edge(const Shape& shape, int i) const {
    const Vector3 vector = edge_length_ * axis + shape.displacement[i + 1] - shape.displacement[i];
    const double length = vector.norm(), c = std::cos(shape.angle[i]), s = std::sin(shape.angle[i]);
    Edge edge{.tangent = vector / length, .length = length, .first = {}, .second = {}};
    const Vector3& reference = shape.reference[i];
    edge.first = c * reference + s * edge.tangent.cross(reference);
    edge.second = edge.tangent.cross(edge.first);
    return edge;
}

// The base's own edge is the clamp's direction. A pinned base has none: its edge goes along with the first one, so that nothing
// is bent wherever that swings, and what it holds is the spin about it.
Edge Chain::edge_before(const Shape& shape, int joint, const Edge& after) const {
    if (joint > 0) return edge(shape, joint - 1);
    if (hinged(joint)) {
        const Vector3& reference = shape.reference[0];
        return {.tangent = after.tangent, .length = edge_length_, .first = reference, .second = after.tangent.cross(reference)};
    }
    return {.tangent = axis, .length = edge_length_, .first = base_director, .second = axis.cross(base_director)};
}

void Chain::move(const VectorX& dx, Shape& shape) const {
    Vector3 before = axis, reference_before = base_director;
    for (int i = 0; i < edges(); ++i) {
        const Vector3 old = edge_length_ * axis + shape.displacement[i + 1] - shape.displacement[i];
        // The far node has not moved yet, the near one has: undo that.
        const Vector3 was = i == 0 ? old : Vector3(old + dx.segment<3>(unknown_of(i)));
        shape.displacement[i + 1] += dx.segment<3>(unknown_of(i + 1));
        shape.angle[i] += dx[unknown_of(i + 1) + 3];
        const Vector3 tangent = (edge_length_ * axis + shape.displacement[i + 1] - shape.displacement[i]).normalized();
        Vector3& reference = shape.reference[i];
        reference = transported(reference, was.normalized(), tangent);
        const Vector3 from_before = transported(reference_before, before, tangent);
        const double turn = std::atan2(tangent.dot(from_before.cross(reference)), from_before.dot(reference));
        shape.reference_twist[i] += std::remainder(turn - shape.reference_twist[i], 2.0 * std::numbers::pi);
        before = tangent;
        reference_before = reference;
    }
}

// (|e| − ℓ)/ℓ, without the difference of two nearly equal lengths.
double Chain::strained_by(const Shape& shape, int edge) const {
    const Vector3 change = shape.displacement[edge + 1] - shape.displacement[edge];
    const double length = (edge_length_ * axis + change).norm();
    return (2.0 * edge_length_ * axis.dot(change) + change.squaredNorm()) / ((length + edge_length_) * edge_length_);
}

double Chain::tension(const Shape& shape, int edge) const {
    return setup_.section.stretching * strained_by(shape, edge);
}

double Chain::tension_change(const Shape& shape, const VectorX& dx, int edge) const {
    const Vector3 tangent = (edge_length_ * axis + shape.displacement[edge + 1] - shape.displacement[edge]).normalized();
    Vector3 change = dx.segment<3>(unknown_of(edge + 1));
    if (edge > 0) change -= dx.segment<3>(unknown_of(edge));
    return setup_.section.stretching * tangent.dot(change) / edge_length_;
}

double Chain::twist(const Shape& shape, int joint) const {
    if (hinged(joint)) return shape.angle[joint];
    return shape.angle[joint] - (joint > 0 ? shape.angle[joint - 1] : 0.0) + shape.reference_twist[joint];
}

Strain Chain::strain(const Shape& shape, int joint) const {
    const Edge f = edge(shape, joint);
    return Joint(edge_before(shape, joint, f), f, twist(shape, joint)).strain();
}

Vector3 Chain::bending_and_twisting(int joint) const {
    const Vector2 bending = hinged(joint) ? Vector2::Zero() : setup_.section.bending;
    return Vector3(bending[0], bending[1], setup_.section.twisting) / joint_length(joint);
}

Strain Chain::beyond_rest(int joint, const Strain& strain) const {
    return strain - setup_.natural_curvature[joint] * joint_length(joint) * Vector3::UnitX();
}

// What the joint bears: M1, M2 and its torque.
Vector3 Chain::moments(int joint, const Strain& strain, const Viscosity& viscosity) const {
    Strain change = beyond_rest(joint, strain);
    if (viscosity.rate > 0.0) change += viscosity.rate * (strain - (*viscosity.before)[joint]);
    return bending_and_twisting(joint).cwiseProduct(change);
}

double Chain::energy(const Shape& shape) const {
    double sum = 0.0;
    for (int i = 0; i < edges(); ++i) {
        const double stretch = strained_by(shape, i);
        sum += 0.5 * setup_.section.stretching * edge_length_ * stretch * stretch +
               0.5 * bending_and_twisting(i).dot(beyond_rest(i, strain(shape, i)).cwiseAbs2());
    }
    return sum;
}

// visit(i, joint, f) for each joint from the base on; f is the edge that begins there.
template <class Visit>
void Chain::each_joint(const Shape& shape, Visit visit) const {
    Edge e = edge_before(shape, 0, edge(shape, 0));
    for (int i = 0; i < edges(); ++i) {
        const Edge f = edge(shape, i);
        visit(i, Joint(e, f, twist(shape, i)), f);
        e = f;
    }
}

void Chain::gradient(const Shape& shape, const Viscosity& viscosity, VectorX& gradient) const {
    gradient.setZero();
    add_stretching(shape, gradient);
    each_joint(shape, [&](int i, const Joint& joint, const Edge&) {
        add_joint(i, joint.gradients().weighed(moments(i, joint.strain(), viscosity)), gradient);
    });
}

void Chain::linearise(const Shape& shape, const std::vector<double>& tensions, const Viscosity& viscosity, BandLdlt& tangent,
                      VectorX& gradient) const {
    gradient.setZero();
    add_stretching(shape, gradient);
    each_joint(shape, [&](int i, const Joint& joint, const Edge& f) {
        const Vector3 moment = moments(i, joint.strain(), viscosity);
        const Vector3 stiffness = (1.0 + viscosity.rate) * bending_and_twisting(i);
        const Joint::Gradients g = joint.gradients();
        add_joint(i, g.weighed(moment), gradient);

        JointMatrix h = joint.hessian(moment);
        h.noalias() += stiffness[0] * g.first * g.first.transpose();
        h.noalias() += stiffness[1] * g.second * g.second.transpose();
        h.noalias() += stiffness[2] * g.twist * g.twist.transpose();
        // The edge's own stretching: EA/ℓ t tᵀ + N/|e| (1 − t tᵀ).
        const Matrix3 along = f.tangent * f.tangent.transpose();
        h.block<3, 3>(4, 4) +=
            setup_.section.stretching / edge_length_ * along + tensions[i] / f.length * (Matrix3::Identity() - along);
        add_joint(i, h, tangent);
    });
}

void Chain::add_stretching(const Shape& shape, VectorX& gradient) const {
    for (int i = 0; i < edges(); ++i) {
        const Vector3 vector = edge_length_ * axis + shape.displacement[i + 1] - shape.displacement[i];
        const Vector3 pull = tension(shape, i) * vector.normalized();
        gradient.segment<3>(unknown_of(i + 1)) += pull;
        if (i > 0) gradient.segment<3>(unknown_of(i)) -= pull;
    }
}

// e = x_i − x_{i−1} and f = x_{i+1} − x_i.
void Chain::add_joint(int joint, const JointVector& g, VectorX& gradient) const {
    gradient.segment<3>(unknown_of(joint + 1)) += g.segment<3>(4);
    gradient[unknown_of(joint + 1) + 3] += g[7];
    if (joint == 0) return;
    gradient.segment<3>(unknown_of(joint)) += g.head<3>() - g.segment<3>(4);
    gradient[unknown_of(joint) + 3] += g[3];
    if (joint > 1) gradient.segment<3>(unknown_of(joint - 1)) -= g.head<3>();
}

void Chain::add_joint(int joint, const JointMatrix& h, BandLdlt& tangent) const {
    // [x_{i−1} (3), x_i (3), θe, x_{i+1} (3), θf] and where they stand among the unknowns.
    constexpr int place[11] = {0, 1, 2, 4, 5, 6, 7, 8, 9, 10, 11};
    const Matrix3 ee = h.block<3, 3>(0, 0), ef = h.block<3, 3>(0, 4), ff = h.block<3, 3>(4, 4);
    Eigen::Matrix<double, 11, 11> k;    // its lower triangle
    k.block<3, 3>(0, 0) = ee;
    k.block<3, 3>(3, 0) = ef.transpose() - ee;
    k.block<3, 3>(3, 3) = ee - ef - ef.transpose() + ff;
    k.block<1, 3>(6, 0) = -h.block<1, 3>(3, 0);
    k.block<1, 3>(6, 3) = h.block<1, 3>(3, 0) - h.block<1, 3>(3, 4);
    k(6, 6) = h(3, 3);
    k.block<3, 3>(7, 0) = -ef.transpose();
    k.block<3, 3>(7, 3) = ef.transpose() - ff;
    k.block<3, 1>(7, 6) = h.block<3, 1>(4, 3);
    k.block<3, 3>(7, 7) = ff;
    k.block<1, 3>(10, 0) = -h.block<1, 3>(7, 0);
    k.block<1, 3>(10, 3) = h.block<1, 3>(7, 0) - h.block<1, 3>(7, 4);
    k(10, 6) = h(7, 3);
    k.block<1, 3>(10, 7) = h.block<1, 3>(7, 4);
    k(10, 10) = h(7, 7);
    const int origin = 4 * (joint - 2);
    const int first = joint == 0 ? 7 : joint == 1 ? 3 : 0;    // what belongs to the base doesn't move
    for (int b = first; b < 11; ++b) {
        for (int a = b; a < 11; ++a) tangent.add(origin + place[a], origin + place[b], k(a, b));
    }
}

}    // namespace stylet::rod
