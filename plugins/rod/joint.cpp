#include "joint.h"

namespace stylet::rod {

namespace {

Matrix3 cross(const Vector3& v) {    // [v]×
    Matrix3 m;
    m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    return m;
}

Matrix3 both_ways(const Vector3& a, const Vector3& b) {    // a bᵀ + b aᵀ
    const Matrix3 m = a * b.transpose();
    return m + m.transpose();
}

}    // namespace

Joint::Joint(const Edge& e, const Edge& f, double twist)
    : e_(e),
      f_(f),
      chi_(1.0 + e.tangent.dot(f.tangent)),
      binormal_(2.0 / chi_ * e.tangent.cross(f.tangent)),
      mean_((e.tangent + f.tangent) / chi_),
      strain_(0.5 * binormal_.dot(e.second + f.second), -0.5 * binormal_.dot(e.first + f.first), twist) {}

Joint::Gradients Joint::gradients() const {
    const Vector3 first = (e_.first + f_.first) / chi_, second = (e_.second + f_.second) / chi_;
    const Strain& k = strain_;
    Gradients g;
    g.first << (f_.tangent.cross(second) - k[0] * mean_) / e_.length, -0.5 * binormal_.dot(e_.first),
        -(e_.tangent.cross(second) + k[0] * mean_) / f_.length, -0.5 * binormal_.dot(f_.first);
    g.second << -(f_.tangent.cross(first) + k[1] * mean_) / e_.length, -0.5 * binormal_.dot(e_.second),
        (e_.tangent.cross(first) - k[1] * mean_) / f_.length, -0.5 * binormal_.dot(f_.second);
    g.twist << 0.5 * binormal_ / e_.length, -1.0, 0.5 * binormal_ / f_.length, 1.0;
    return g;
}

JointMatrix Joint::hessian(const Vector3& moments) const {
    JointMatrix h = JointMatrix::Zero();
    add_bending(moments, h);
    if (moments[2] != 0.0) add_twisting(moments[2], h);    // a needle whose tip is free to turn is hardly ever twisted
    return h;
}

// κ = b·(qe + qf)/2 is both curvatures weighed by their moments: its second derivatives are linear in q = M1 d2 − M2 d1.
void Joint::add_bending(const Vector3& moments, JointMatrix& h) const {
    const Vector3 qe = moments[0] * e_.second - moments[1] * e_.first, qf = moments[0] * f_.second - moments[1] * f_.first;
    const Vector3 turned_e = -moments[0] * e_.first - moments[1] * e_.second;    // dqe/dθe
    const Vector3 turned_f = -moments[0] * f_.first - moments[1] * f_.second;
    const Vector3 q = (qe + qf) / chi_;
    const Vector3 across_e = f_.tangent.cross(q), across_f = e_.tangent.cross(q);
    const double k = 0.5 * binormal_.dot(qe + qf), le = e_.length, lf = f_.length;
    const Matrix3 identity = Matrix3::Identity();
    const Matrix3 mean = 2.0 * k * mean_ * mean_.transpose();

    h.block<3, 3>(0, 0) += (mean - both_ways(across_e, mean_) - k / chi_ * (identity - e_.tangent * e_.tangent.transpose()) +
                            0.25 * both_ways(binormal_, qe)) /
                           (le * le);
    h.block<3, 3>(4, 4) += (mean + both_ways(across_f, mean_) - k / chi_ * (identity - f_.tangent * f_.tangent.transpose()) +
                            0.25 * both_ways(binormal_, qf)) /
                           (lf * lf);
    const Matrix3 ef = (mean - across_e * mean_.transpose() + mean_ * across_f.transpose() - cross(q) -
                        k / chi_ * (identity + e_.tangent * f_.tangent.transpose())) /
                       (le * lf);
    h.block<3, 3>(0, 4) += ef;
    h.block<3, 3>(4, 0) += ef.transpose();

    const auto add_turning = [&](int angle, const Vector3& turned) {
        const double change = 0.5 * binormal_.dot(turned);
        const Vector3 by_e = (f_.tangent.cross(turned) / chi_ - change * mean_) / le;
        const Vector3 by_f = -(e_.tangent.cross(turned) / chi_ + change * mean_) / lf;
        h.block<3, 1>(0, angle) += by_e;
        h.block<3, 1>(4, angle) += by_f;
        h.block<1, 3>(angle, 0) += by_e.transpose();
        h.block<1, 3>(angle, 4) += by_f.transpose();
    };
    add_turning(3, turned_e);
    add_turning(7, turned_f);
    h(3, 3) -= 0.5 * binormal_.dot(qe);
    h(7, 7) -= 0.5 * binormal_.dot(qf);
}

void Joint::add_twisting(double torque, JointMatrix& h) const {
    const double le = e_.length, lf = f_.length;
    h.block<3, 3>(0, 0) -= 0.25 * torque / (le * le) * both_ways(binormal_, e_.tangent + mean_);
    h.block<3, 3>(4, 4) -= 0.25 * torque / (lf * lf) * both_ways(binormal_, f_.tangent + mean_);
    const Matrix3 ef = 0.5 * torque / (le * lf) * (2.0 / chi_ * cross(e_.tangent) - binormal_ * mean_.transpose());
    h.block<3, 3>(0, 4) += ef;
    h.block<3, 3>(4, 0) += ef.transpose();
}

}    // namespace stylet::rod
