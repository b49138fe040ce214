#include "half_space.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stylet::half_space {

namespace {

// A piece of shaft of no length stands where the tip stands. This much softer, in its own place, it stays a contact of its own.
constexpr double independence = 1e-9;
// An odd number of cache lines between columns, so that a row of the compliance doesn't fall into one cache set.
constexpr int column_padding = 8;
// [m] A point this close above the surface is on it: rounding must not push a touching tip out of the tissue.
constexpr double surface_tolerance = 1e-9;
constexpr double infinity = std::numeric_limits<double>::infinity();

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

double radius_of(const NeedleSetup* needle) {
    return needle == nullptr ? 0.0 : needle->radius;
}

}    // namespace

HalfSpace::HalfSpace(const Setup& setup)
    : setup_(*setup.tissue),
      kernel_(common_poisson_ratio(*setup.tissue), radius_of(setup.needle)),
      elasticity_(setup_.layers, radius_of(setup.needle)),
      placed_(max_contacts),
      patches_(setup_, 0.5 * kernel_.blur()),
      free_(3 * max_contacts),
      compliance_(MatrixX::Zero(3 * max_contacts + column_padding, 3 * max_contacts)),
      displacement_(3 * max_contacts),
      shift_(3 * max_contacts) {
    for (const Layer& layer : setup_.layers) {
        bottoms_.push_back((bottoms_.empty() ? 0.0 : bottoms_.back()) + layer.thickness);
    }
    bottoms_.back() = setup_.extent.z();
    trial_.spare = state_.spare = infinity;
    trial_.contacts.reserve(max_contacts);
    state_.contacts.reserve(max_contacts);
}

void HalfSpace::bear(std::span<const Patch> patches) {
    patches_.place(patches);
    next_load_ = VectorX::Zero(3 * patches_.count());
    for (State* state : {&trial_, &state_}) state->load = state->patches_moved = next_load_;
    known_ = 0;
}

void HalfSpace::load(std::span<const Vector3> forces) {
    for (std::size_t i = 0; i < forces.size(); ++i) next_load_.segment<3>(3 * static_cast<Eigen::Index>(i)) = forces[i];
}

void HalfSpace::predict(double /*dt: no inertia*/) {
    trial_.load = next_load_;
}

void HalfSpace::rollback() {
    trial_ = state_;
    next_load_ = state_.load;
}

HalfSpace::Placed HalfSpace::place(const ContactPoint& point) const {
    const Footprint footprint(point);
    const double count = static_cast<double>(footprint.samples().size());
    return {.footprint = footprint, .weight = 1.0 / (count * std::sqrt(elasticity_.modulus(-footprint.middle().z())))};
}

Matrix3 HalfSpace::block(const Placed& i, const Placed& j) const {
    Matrix3 sum = Matrix3::Zero();
    for (const Vector3& a : i.footprint.samples()) {
        for (const Vector3& b : j.footprint.samples()) sum += kernel_(a, b);
    }
    return i.weight * j.weight * sum;
}

void HalfSpace::fill(int row, int count) {
    const Placed& placed = placed_[row];
    for (int other = 0; other < count; ++other) {
        if (other == row) continue;
        const Matrix3 mutual = block(placed, placed_[other]);
        compliance_.block<3, 3>(3 * row, 3 * other) = mutual;
        compliance_.block<3, 3>(3 * other, 3 * row) = mutual.transpose();
    }
    const Matrix3 self = block(placed, placed);
    compliance_.block<3, 3>(3 * row, 3 * row) = 0.5 * (1.0 + independence) * (self + self.transpose());
    if (placed.footprint.point().tip) {    // the open track behind the tip: never stiffer than a punch on the surface
        const Vector3 surface = placed.weight * placed.weight * kernel_(Vector3::Zero(), Vector3::Zero()).diagonal();
        auto diagonal = compliance_.block<3, 3>(3 * row, 3 * row).diagonal();
        diagonal = diagonal.cwiseMax(surface);
    }
    if (!patches_.none()) patches_.meet(row, placed.footprint.samples(), placed.weight);
}

// Where the contacts would be if only the patches were loaded.
void HalfSpace::shift_contacts(ContactPoints points) {
    const auto count = static_cast<Eigen::Index>(points.size());
    shift_.head(3 * count).noalias() = patches_.of_contacts(count) * trial_.load;
    for (Eigen::Index i = 0; i < count; ++i) free_.segment<3>(3 * i) = points[i].material + shift_.segment<3>(3 * i);
}

Linearisation HalfSpace::linearise(ContactPoints points, double /*shift: no inertia*/) {
    const int count = static_cast<int>(points.size());
    for (int i = 0; i < count; ++i) {
        if (i < known_ && placed_[i].footprint.is_of(points[i])) continue;
        placed_[i] = place(points[i]);
        free_.segment<3>(3 * i) = points[i].material;
        fill(i, std::max(i + 1, std::min(known_, count)));
    }
    known_ = count;
    if (!patches_.none()) shift_contacts(points);
    return {.free = {free_.data(), 3 * count},
            .compliance = {compliance_.data(), 3 * count, 3 * count, Eigen::OuterStride<>(compliance_.outerStride())},
            .negatives = 0};
}

StepReport HalfSpace::try_step(ContactPoints points, Forces forces) {
    const Linearisation now = linearise(points, 0.0);
    auto displacement = displacement_.head(forces.size());
    displacement.noalias() = now.compliance.selfadjointView<Eigen::Lower>() * forces;
    trial_.energy = 0.0;
    trial_.spare = infinity;
    if (!patches_.none()) move_patches(forces);
    trial_.energy += 0.5 * forces.dot(displacement);
    trial_.contacts.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto at = 3 * static_cast<Eigen::Index>(i);
        trial_.contacts.push_back({.point = points[i], .force = forces.segment<3>(at)});
        if (points[i].tip) trial_.spare = std::min(trial_.spare, room_at(-points[i].material.z()) + displacement[at + 2]);
    }
    return {};
}

// The patches' share of a step, and theirs in where the contacts go.
void HalfSpace::move_patches(const Forces& forces) {
    displacement_.head(forces.size()) += shift_.head(forces.size());
    trial_.patches_moved.noalias() = patches_.own() * trial_.load;
    trial_.patches_moved.noalias() += patches_.of_contacts(forces.size() / 3).transpose() * forces;
    trial_.energy = 0.5 * trial_.load.dot(trial_.patches_moved);
    for (int i = 0; i < patches_.count(); ++i)
        trial_.spare = std::min(trial_.spare, room_at(0.0) + trial_.patches_moved[3 * i + 2]);
}

Vector3 HalfSpace::displacement(const Vector3& material) const {
    Vector3 sum = patches_.displacement(material, state_.load);
    for (const Pressed& contact : state_.contacts) {
        const Footprint footprint(contact.point);
        const double count = static_cast<double>(footprint.samples().size());
        Vector3 shares = Vector3::Zero();
        for (const Vector3& sample : footprint.samples()) shares += kernel_(material, sample) * contact.force;
        sum += shares / (count * std::sqrt(elasticity_.modulus(-footprint.middle().z())));
    }
    return sum / std::sqrt(elasticity_.modulus(-material.z()));
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
    if (state_.spare >= 0.0) return nullptr;
    return setup_.layers.size() > 1 ? "beyond validity: the dent is deeper than the layer"
                                    : "beyond validity: the dent is deeper than the block";
}

}    // namespace stylet::half_space

STYLET_PLUGIN(
    stylet::half_space::HalfSpace, "half_space", stylet::no_parameters,
    .summary = "The cheapest honest tissue: an elastic half-space, no mesh",
    .formula =
        "u_i = sum_j W_ij f_j\n"
        "W_ij = mean over both pieces of track, or loaded patches, of K(x, y) / sqrt(E_i E_j)\n"
        "K [1/m] Mindlin's point load, blurred to the needle's radius a; at a tip on the surface (1 - nu^2)/(2 a) along z\n"
        "a square patch of side s under a force F along z: mean displacement 0.9464 (1 - nu^2) F/(s E)",
    .source =
        "Mindlin 1936; Selvadurai 1976 for the disc; Love 1929, Dydo and Busby 1995 for loaded patches. Deviation: the "
        "blur, and at any depth the tip keeps at least the compliance of a punch on the surface, because the track behind "
        "it is open",
    .validity =
        "Small strain, quasi-static, one Poisson's ratio. Layers act by their local modulus: exact for one layer, blind "
        "to what lies between two points. Loaded patches are rectangles on the top and have the top layer's modulus. Sides "
        "and bottom of the block are not felt")
