#include "contact/near_field.h"

#include <algorithm>
#include <cmath>

namespace stylet::corotational_fem {
namespace {

constexpr double deviations = 3.0;    // ρ/σ of a ball with density (1 − r²/ρ²)²
// σ/ρ of a node's own hat function, h/√6 for ρ = 2h: what a mesh's displacement at a point is blurred by.
constexpr double hat = 0.204;
// Beyond this many lengths of the longer piece two Gauss points along each do for eight: to 0.3 % of a mutual compliance.
constexpr double apart = 1.5;
// A piece of shaft of no length stands where the tip stands. This much softer, in its own place, it stays a contact of its own.
constexpr double independence = 1e-9;

// An odd number of cache lines between columns, so that a row doesn't fall into one cache set.
constexpr int column_padding = 8;

template <typename A, typename B, typename Function>
Matrix3 mean_over(const A& a, const B& b, const Function& function) {
    Matrix3 sum = Matrix3::Zero();
    for (const auto& x : a) {
        for (const auto& y : b) sum += function(x, y);
    }
    return sum / static_cast<double>(a.size() * b.size());
}

}    // namespace

NearField::NearField(const TissueSetup& tissue, const Spread& spread, const RegionsFelt* regions)
    : elasticity_(tissue.layers, spread.needle_radius()),
      regions_(regions),
      spread_(spread),
      compliance_(MatrixX::Zero(3 * max_contacts + column_padding, 3 * max_contacts)) {
    const ContactPoint surface{.material = Vector3::Zero(), .span = Vector3::Zero(), .arclength = 0.0, .tip = true};
    placed_.assign(max_contacts, placed(surface));
}

NearField::Placed NearField::placed(const ContactPoint& point) const {
    Placed placed;
    placed.footprint = Footprint(point);
    placed.balls = spread_.balls(point);
    for (int b = 0; b < placed.balls.count; ++b)
        placed.loads[b] = GaussianLoad(placed.balls.centres[b], placed.balls.radius / deviations);
    placed.length = point.span.norm();
    const Felt felt = felt_at(placed.footprint.middle());
    placed.poisson_ratio = felt.poisson_ratio;
    placed.weight = 1.0 / std::sqrt(felt.youngs_modulus);
    return placed;
}

Felt NearField::felt_at(const Vector3& point) const {
    if (regions_ != nullptr) return regions_->at(point);
    return {elasticity_.modulus(-point.z()), elasticity_.poisson_ratio(-point.z())};
}

void NearField::place(int contact, const ContactPoint& point) {
    Placed& there = placed_[contact];
    if (there.footprint.is_of(point)) return;
    there = placed(point);
    there.changed = true;
}

// What the mesh resolves, times √(E_i E_j).
Matrix3 NearField::meshed(const Placed& i, const Placed& j) {
    const double nu = 0.5 * (i.poisson_ratio + j.poisson_ratio);
    return mean_over(i.shares(), j.shares(),
                     [nu](const GaussianLoad& at, const GaussianLoad& source) { return response(nu, at, source); });
}

Matrix3 NearField::block(const Placed& i, const Placed& j) const {
    const double nu = 0.5 * (i.poisson_ratio + j.poisson_ratio);
    const MindlinKernel kernel(nu, spread_.needle_radius());
    const double distance = (i.footprint.middle() - j.footprint.middle()).norm();
    const bool far = distance >= apart * std::max(i.length, j.length);
    const Matrix3 needle =
        far ? mean_over(i.centres(), j.centres(), kernel) : mean_over(i.footprint.samples(), j.footprint.samples(), kernel);
    return i.weight * j.weight * (needle - meshed(i, j));
}

Matrix3 NearField::own_block(const Placed& i) const {
    const MindlinKernel kernel(i.poisson_ratio, spread_.needle_radius());
    Matrix3 needle = (1.0 + independence) * mean_over(i.footprint.samples(), i.footprint.samples(), kernel);
    if (i.footprint.point().tip) {    // the open track behind the tip: never stiffer than a punch on the surface
        const Vector3 surface = kernel(Vector3::Zero(), Vector3::Zero()).diagonal();
        needle.diagonal() = needle.diagonal().cwiseMax(surface);
    }
    const Matrix3 own = i.weight * i.weight * (needle - meshed(i, i));
    return 0.5 * (own + own.transpose());
}

void NearField::fill(int row, int count) {
    for (int other = 0; other < count; ++other) {
        if (other == row) continue;
        const int i = std::min(row, other), j = std::max(row, other);    // the same bits whichever of them has moved
        const Matrix3 mutual = block(placed_[i], placed_[j]);
        compliance_.block<3, 3>(3 * i, 3 * j) = mutual;
        compliance_.block<3, 3>(3 * j, 3 * i) = mutual.transpose();
    }
    compliance_.block<3, 3>(3 * row, 3 * row) = own_block(placed_[row]);
    placed_[row].changed = false;
}

Eigen::Map<const MatrixX, Eigen::Unaligned, Eigen::OuterStride<>> NearField::compliance(int contacts) {
    for (int i = 0; i < contacts; ++i) {
        if (i >= known_ || placed_[i].changed) fill(i, std::max(i + 1, std::min(known_, contacts)));
    }
    known_ = contacts;
    return {compliance_.data(), 3 * contacts, 3 * contacts, Eigen::OuterStride<>(compliance_.outerStride())};
}

Vector3 NearField::displacement(const Vector3& material, Forces forces) const {
    const int contacts = static_cast<int>(forces.size() / 3);
    const Placed here = placed({.material = material, .span = Vector3::Zero(), .arclength = 0.0, .tip = true});
    if (here.balls.count == 0) return Vector3::Zero();
    const GaussianLoad seen(here.balls.centres[0], hat * here.balls.radius);
    Vector3 sum = Vector3::Zero();
    for (int i = 0; i < contacts; ++i) {
        const Placed& contact = placed_[i];
        const double nu = 0.5 * (here.poisson_ratio + contact.poisson_ratio);
        const MindlinKernel kernel(nu, spread_.needle_radius());
        const Vector3 force = contact.weight * forces.segment<3>(3 * i);
        sum += mean_over(here.centres(), contact.footprint.samples(), kernel) * force;
        for (const GaussianLoad& share : contact.shares()) sum -= response(nu, seen, share) * force / contact.balls.count;
    }
    return here.weight * sum;
}

}    // namespace stylet::corotational_fem
