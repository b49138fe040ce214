#include "corotational_fem.h"

#include "making.h"
#include "parameters.h"

#include <algorithm>

namespace stylet::corotational_fem {

namespace {

// An odd number of cache lines between columns, so that a row of the compliance doesn't fall into one cache set.
constexpr int column_padding = 8;

double radius_of(const Setup& setup) {
    return setup.needle == nullptr ? 0.0 : setup.needle->radius;
}

SharedBy shared_by(const Parameters& parameters) {
    const bool area = parameters.has("load_shared_by") && parameters.text("load_shared_by") == "area";
    return area ? SharedBy::area : SharedBy::nodes;
}

std::optional<RegionsFelt> regions_of(const Setup& setup, const Mesh& mesh, const Locator& locator) {
    if (!setup.parameters.has("mesh")) return std::nullopt;
    return RegionsFelt(mesh, locator, setup.tissue->layers, radius_of(setup));
}

}    // namespace

CorotationalFem::CorotationalFem(const Setup& setup)
    : setup_(*setup.tissue),
      mesh_(mesh_of(setup)),
      materials_(materials_of(setup_)),
      locator_(mesh_),
      loaded_(shared_by(setup.parameters)),
      spread_(mesh_, radius_of(setup)),
      regions_(regions_of(setup, mesh_, locator_)),
      near_field_(setup_, spread_, regions_ ? &*regions_ : nullptr),
      solver_(solver_of(setup, mesh_, materials_)),
      free_(3 * max_contacts),
      moved_(3 * max_contacts),
      compliance_(MatrixX::Zero(3 * max_contacts + column_padding, 3 * max_contacts)) {
    placed_.reserve(max_contacts);
    trial_.spare = setup_.extent.z();
    trial_.forces = VectorX::Zero(3 * max_contacts);
    state_ = trial_;
}

void CorotationalFem::bear(std::span<const Patch> patches) {
    loaded_.place(patches, mesh_, locator_.boundary());
    solver_->load({});
}

Vector3 CorotationalFem::patch_displacement(int i) const {
    Vector3 sum = Vector3::Zero();
    for (const NodeWeight& each : loaded_.weights_of(i)) sum += each.weight * solver_->displacement(each.node);
    return sum;
}

// Asked for the same points twice, neither the mesh nor the near field works for them twice.
void CorotationalFem::place(ContactPoints points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i < placed_.size() && placed_[i].is_of(points[i])) continue;
        if (i < placed_.size()) {
            placed_[i] = Footprint(points[i]);
        } else {
            placed_.emplace_back(points[i]);
        }
        const int contact = static_cast<int>(i);
        solver_->place(contact, spread_.of(points[i]));
        near_field_.place(contact, points[i]);
    }
}

Linearisation CorotationalFem::linearise(ContactPoints points, double /*shift: the solver's tangent is definite*/) {
    const auto count = static_cast<Eigen::Index>(points.size());
    place(points);
    auto compliance = compliance_.topLeftCorner(3 * count, 3 * count);
    solver_->linearise(static_cast<int>(count), free_.head(3 * count), compliance);
    compliance += near_field_.compliance(static_cast<int>(count));
    for (Eigen::Index i = 0; i < count; ++i) free_.segment<3>(3 * i) += points[i].material;
    return {.free = {free_.data(), 3 * count},
            .compliance = {compliance_.data(), 3 * count, 3 * count, Eigen::OuterStride<>(compliance_.outerStride())},
            .negatives = 0};
}

StepReport CorotationalFem::try_step(ContactPoints points, Forces forces) {
    place(points);
    const auto count = static_cast<Eigen::Index>(points.size());
    const StepReport report = solver_->try_step(forces);
    auto moved = moved_.head(forces.size());
    moved.noalias() = near_field_.compliance(static_cast<int>(count)) * forces;
    trial_.near_energy = 0.5 * forces.dot(moved);
    trial_.forces.head(forces.size()) = forces;
    trial_.count = count;
    trial_.spare = setup_.extent.z();
    for (Eigen::Index i = 0; i < count; ++i) {
        if (points[i].tip) trial_.spare = std::min(trial_.spare, setup_.extent.z() + points[i].material.z() + moved[3 * i + 2]);
    }
    return report;
}

void CorotationalFem::commit() {
    solver_->commit();
    state_ = trial_;
}

void CorotationalFem::rollback() {
    solver_->rollback();
    trial_ = state_;
}

EnergyReport CorotationalFem::energy() const {
    EnergyReport energy = solver_->energy();
    energy.stored += trial_.near_energy;
    return energy;
}

Vector3 CorotationalFem::displacement(const Vector3& material) const {
    const MeshPlace place = locator_.find(material);
    if (place.tetrahedron == no_tetrahedron) return Vector3::Zero();
    Vector3 sum = near_field_.displacement(material, {state_.forces.data(), 3 * state_.count});
    for (int a = 0; a < 4; ++a) sum += place.weights[a] * solver_->displacement(mesh_.tetrahedra[place.tetrahedron][a]);
    return sum;
}

Location CorotationalFem::locate(const Vector3& material) const {
    const MeshPlace place = locator_.find(material);
    return {.layer = place.tetrahedron == no_tetrahedron ? outside : mesh_.layers[place.tetrahedron], .depth = -material.z()};
}

const char* CorotationalFem::beyond_validity() const {
    if (state_.spare <= 0.0) return "beyond validity: the tip is pressed through the tissue's bottom";
    return solver_->inverted() ? "beyond validity: a tetrahedron is turned inside out" : nullptr;
}

}    // namespace stylet::corotational_fem

STYLET_PLUGIN(
    stylet::corotational_fem::CorotationalFem, "corotational_fem", stylet::corotational_fem::parameters,
    .summary = "A finite-element tissue of tetrahedra that turn with it: any shape, any layers, large rotations",
    .formula =
        "w + f + J^T l - dU/du - M (u - u~)/dt^2 = 0,  u~ = u_n + dt v_n\n"
        "U = sum over tetrahedra of V [m |F - R|^2 + L/2 t^2],  t = tr(R^T F) - 3\n"
        "F = R S a tetrahedron's deformation, R its rotation, m and L Lame's moduli [Pa], w weight, f loads, l contact forces; "
        "a contact moves by J u + C l, C what the mesh cannot resolve of a needle",
    .source =
        "He, Chen and Tang, Table 4; Mueller and Gross 2004; Irving, Teran and Fedkiw 2004 (inverted tetrahedra); Kuhn 1960 "
        "(cells); de Souza Neto et al. 2005 (pressure by patches). Deviation: the energy's exact derivative, not the warped "
        "stiffness alone; the needle's own size by Mindlin's solution",
    .validity =
        "Large rotations, stretches of some tens of percent (stress is linear in them), isotropic layers. A pressure a "
        "tetrahedron locks where Poisson's ratio nears 0.5. quasi_newton is off by about `accuracy` of the displacements a step "
        "and a few times that over a swing, far more under a stiff layer on one a million times as soft; "
        "newton by nothing and is too slow for a hand. Within two cells of a side or of the bottom a needle feels a half-space. "
        "The tissue doesn't touch itself, and a needle's track doesn't open")
