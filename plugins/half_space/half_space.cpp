#include "half_space.h"

#include <algorithm>
#include <cmath>

namespace stylet::half_space {

namespace {

// Points that share a shaft contact's force evenly. A fixed number: the compliance then changes smoothly while the piece grows.
constexpr int shaft_samples = 8;
// A tip as large as a radius feels an interface from about this many radii away.
constexpr double interface_radii = 4.0;
// A piece of shaft of no length stands where the tip stands. This much softer, in its own place, it stays a contact of its own.
constexpr double independence = 1e-9;
// An odd number of cache lines between columns, so that a row of the compliance doesn't fall into one cache set.
constexpr int column_padding = 8;
// [m] A point this close above the surface is on it: rounding must not push a touching tip out of the tissue.
constexpr double surface_tolerance = 1e-9;

double common_poisson_ratio(const TissueSetup& tissue) {
    const double first = tissue.layers.front().poisson_ratio;
    for (const Layer& layer : tissue.layers) {
        if (layer.poisson_ratio != first) {
            throw Error(
                "layers",
                "layers have different Poisson ratios, wanted one for all: half_space knows layers by their modulus alone");
        }
    }
    return first;
}

// The needle's arclength at a contact means nothing to the tissue.
bool same_tissue(const ContactPoint& a, const ContactPoint& b) {
    return a.material == b.material && a.span == b.span && a.tip == b.tip;
}

}    // namespace

HalfSpace::HalfSpace(const Setup& setup)
    : setup_(*setup.tissue),
      kernel_(common_poisson_ratio(*setup.tissue), setup.needle->radius),
      radius_(setup.needle->radius),
      patches_(max_contacts),
      free_(3 * max_contacts),
      compliance_(MatrixX::Zero(3 * max_contacts + column_padding, 3 * max_contacts)),
      displacement_(3 * max_contacts) {
    for (const Layer& layer : setup_.layers) {
        bottoms_.push_back((bottoms_.empty() ? 0.0 : bottoms_.back()) + layer.thickness);
    }
    bottoms_.back() = setup_.extent.z();
    for (Patch& patch : patches_) patch.samples.resize(shaft_samples);
}

void HalfSpace::place(Patch& patch, const ContactPoint& point) const {
    patch.point = point;
    patch.count = point.tip ? 1 : shaft_samples;
    for (int i = 0; i < patch.count; ++i) {
        patch.samples[i] = point.material + (i + 0.5) / patch.count * point.span;
    }
    const Vector3 middle = point.material + 0.5 * point.span;
    patch.weight = 1.0 / (patch.count * std::sqrt(modulus_at(-middle.z())));
}

Matrix3 HalfSpace::block(const Patch& i, const Patch& j) const {
    Matrix3 sum = Matrix3::Zero();
    for (int a = 0; a < i.count; ++a) {
        for (int b = 0; b < j.count; ++b) sum += kernel_(i.samples[a], j.samples[b]);
    }
    return i.weight * j.weight * sum;
}

void HalfSpace::fill(int row, int count) {
    const Patch& patch = patches_[row];
    for (int other = 0; other < count; ++other) {
        if (other == row) continue;
        const Matrix3 mutual = block(patch, patches_[other]);
        compliance_.block<3, 3>(3 * row, 3 * other) = mutual;
        compliance_.block<3, 3>(3 * other, 3 * row) = mutual.transpose();
    }
    const Matrix3 self = block(patch, patch);
    compliance_.block<3, 3>(3 * row, 3 * row) = 0.5 * (1.0 + independence) * (self + self.transpose());
    if (patch.point.tip) {    // the open track behind the tip: never stiffer than a punch on the surface
        const Vector3 surface = patch.weight * patch.weight * kernel_(Vector3::Zero(), Vector3::Zero()).diagonal();
        auto diagonal = compliance_.block<3, 3>(3 * row, 3 * row).diagonal();
        diagonal = diagonal.cwiseMax(surface);
    }
}

Linearisation HalfSpace::linearise(ContactPoints points, double /*shift: no inertia*/) {
    const int count = static_cast<int>(points.size());
    for (int i = 0; i < count; ++i) {
        if (i < known_ && same_tissue(patches_[i].point, points[i])) continue;
        place(patches_[i], points[i]);
        free_.segment<3>(3 * i) = points[i].material;
        fill(i, std::max(i + 1, std::min(known_, count)));
    }
    known_ = count;
    return {.free = {free_.data(), 3 * count},
            .compliance = {compliance_.data(), 3 * count, 3 * count, Eigen::OuterStride<>(compliance_.outerStride())},
            .negatives = 0};
}

StepReport HalfSpace::try_step(ContactPoints points, Forces forces) {
    const Linearisation now = linearise(points, 0.0);
    auto displacement = displacement_.head(forces.size());
    displacement.noalias() = now.compliance.selfadjointView<Eigen::Lower>() * forces;
    trial_.energy = 0.5 * forces.dot(displacement);
    trial_.dent = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].tip) continue;
        trial_.dent = -displacement[3 * static_cast<Eigen::Index>(i) + 2];
        trial_.room = room_at(-points[i].material.z());
    }
    return {};
}

Vector3 HalfSpace::displacement(const Vector3&) const {
    return Vector3::Zero();
}

// Geometric blend over a few radii on either side of each interface: a tip that crosses one feels it come.
double HalfSpace::modulus_at(double depth) const {
    const double half_width = interface_radii * radius_;
    double modulus = setup_.layers.front().youngs_modulus;
    for (std::size_t i = 0; i + 1 < bottoms_.size(); ++i) {
        const double t = std::clamp(0.5 * (1.0 + (depth - bottoms_[i]) / half_width), 0.0, 1.0);
        modulus *= std::pow(setup_.layers[i + 1].youngs_modulus / setup_.layers[i].youngs_modulus, t * t * (3.0 - 2.0 * t));
    }
    return modulus;
}

int HalfSpace::layer_at(double depth) const {
    const auto below = std::upper_bound(bottoms_.begin(), bottoms_.end() - 1, depth);
    return static_cast<int>(below - bottoms_.begin());
}

Location HalfSpace::locate(const Vector3& material) const {
    const double depth = -material.z();
    const bool inside = depth >= -surface_tolerance && depth <= setup_.extent.z() &&
                        std::abs(material.x()) <= 0.5 * setup_.extent.x() && std::abs(material.y()) <= 0.5 * setup_.extent.y();
    return {.layer = inside ? layer_at(depth) : outside, .depth = depth};
}

double HalfSpace::entry(const Vector3& from, const Vector3& to) const {
    constexpr double none = -1.0;
    if (from.z() < 0.0 || to.z() > 0.0 || !(from.z() > to.z())) return none;
    const double fraction = from.z() / (from.z() - to.z());
    const Vector3 crossing = from + fraction * (to - from);
    return locate({crossing.x(), crossing.y(), 0.0}).layer == outside ? none : fraction;
}

// How thick the tissue of this modulus is here.
double HalfSpace::room_at(double depth) const {
    const int layer = layer_at(depth), last = static_cast<int>(bottoms_.size()) - 1;
    const auto alike = [&](int other) { return setup_.layers[other].youngs_modulus == setup_.layers[layer].youngs_modulus; };
    int top = layer, bottom = layer;
    while (top > 0 && alike(top - 1)) --top;
    while (bottom < last && alike(bottom + 1)) ++bottom;
    return bottoms_[bottom] - (top == 0 ? 0.0 : bottoms_[top - 1]);
}

const char* HalfSpace::beyond_validity() const {
    if (state_.dent <= state_.room) return nullptr;
    return setup_.layers.size() > 1 ? "beyond validity: the dent is deeper than the layer"
                                    : "beyond validity: the dent is deeper than the block";
}

}    // namespace stylet::half_space

STYLET_PLUGIN(
    stylet::half_space::HalfSpace, "half_space", stylet::no_parameters,
    .summary = "The cheapest honest tissue: an elastic half-space, no mesh",
    .formula =
        "u_i = sum_j W_ij f_j\n"
        "W_ij = mean over both pieces of track of K(x, y) / sqrt(E_i E_j)\n"
        "K: Mindlin's point load, blurred to the needle's radius a; on the surface (1 - nu^2)/(2 a E)",
    .source =
        "Mindlin 1936; Selvadurai 1976 for the disc. Deviation: the blur, and at any depth the tip keeps at least the "
        "compliance of a punch on the surface, because the track behind it is open",
    .validity =
        "Small strain, quasi-static, one Poisson's ratio. Layers act by their local modulus: exact for one layer, blind "
        "to what lies between two points. Sides and bottom of the block are not felt")
