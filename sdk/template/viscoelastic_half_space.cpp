// A plugin to copy: a soft tissue that creeps under a load and relaxes in a dent. It reads from top to bottom: what a scene may
// give it, what it computes, and the line that exports it.
#include "kernel.h"

#include <stylet/tissue_model.h>

#include <algorithm>
#include <string>
#include <vector>

namespace stylet::viscoelastic_half_space {
namespace {

constexpr Parameter parameters[] = {
    number("long_term_modulus", "Pa", positive,
           "Young's modulus once all creep is over; the layer's youngs_modulus is what a quick push meets"),
    number("retardation_time", "s", positive, "time constant of the creep under a force that stays"),
};

constexpr int shaft_samples = 4;              // points that share a shaft contact's force evenly
constexpr double independence = 1e-9;         // of a compliance: two contacts in one place stay two
constexpr double surface_tolerance = 1e-9;    // [m] rounding must not push a touching tip out of the tissue

// What makes no sense is refused while loading, by an Error that names the key at fault. In a tick nothing may throw.
const NeedleSetup& needle_of(const Setup& setup) {
    if (setup.needle == nullptr) throw Error("found a scene without a needle, wanted one: its radius is the size of a contact");
    return *setup.needle;
}

const Layer& layer_of(const TissueSetup& tissue) {
    if (tissue.layers.size() != 1) throw Error("layers", "found " + std::to_string(tissue.layers.size()) + " layers, wanted one");
    return tissue.layers.front();
}

}    // namespace

/// A standard linear solid (Zener) of the elastic half-space's shape, by correspondence: Poisson's ratio does not creep, so one
/// compliance C of unit modulus between the contacts serves both springs.
///
///     u = C (f/E₀ + q/E₁)       τ q' = f − q       1/E∞ = 1/E₀ + 1/E₁
///
/// f are the forces, q the part of them that the delayed spring E₁ bears already, τ its retardation time. A constant force creeps
/// with τ, a constant dent relaxes with τ E∞/E₀. A step takes the midpoint rule, so that the work of the forces over it is
/// exactly the change of ½ fᵀCf/E₀ + ½ qᵀCq/E₁ and the loss τ/Δt ΔqᵀCΔq/E₁ ≥ 0.
///
/// Source: Christensen 1982, "Theory of Viscoelasticity", for the solid and the correspondence; kernel.h for C. Deviation: where
/// the needle slides, q goes along with its contact, and ends with it, instead of staying behind in the tissue.
/// Validity: small strain, quasi-static, one layer. Only a contact's own compliance knows that there is a surface: two that lie
/// just below it move each other by up to half too little. The block's sides and bottom are not felt.
class ViscoelasticHalfSpace final : public TissueModel {
public:
    explicit ViscoelasticHalfSpace(const Setup& setup)
        : block_(*setup.tissue),
          prompt_(1.0 / layer_of(block_).youngs_modulus),
          delayed_(1.0 / setup.parameters.number("long_term_modulus") - prompt_),
          retardation_time_(setup.parameters.number("retardation_time")),
          kernel_(layer_of(block_).poisson_ratio, needle_of(setup).radius) {
        if (!(delayed_ > 0.0)) throw Error("long_term_modulus", "found one that is not below the layer's youngs_modulus");
        const double relaxation_time = retardation_time_ * prompt_ / (prompt_ + delayed_);    // [s] τ E∞/E₀
        if (relaxation_time < 0.5 * setup.dt)
            throw Error("retardation_time",
                        "found one so short that a dent relaxes in less than half a time step: that would ring");
        for (auto* points : {&placed_, &state_.points, &trial_.points}) points->reserve(max_contacts);
    }

    void predict(double dt) override { follow_ = dt / (2.0 * retardation_time_ + dt); }

    // u = C (f/E₀ + q/E₁) with q = q_old + follow (f + f_old − 2 q_old): W is what f moves, `free` all the rest.
    Linearisation linearise(ContactPoints points, double /*shift: no inertia*/) override {
        place(points);
        const auto rows = 3 * static_cast<Eigen::Index>(points.size());
        const auto unit = unit_.topLeftCorner(rows, rows);
        const auto f_old = state_.force.head(rows), q_old = state_.delayed.head(rows);
        compliance_.topLeftCorner(rows, rows) = (prompt_ + delayed_ * follow_) * unit;
        scratch_.head(rows) = delayed_ * (q_old + follow_ * (f_old - 2.0 * q_old));
        free_.head(rows).noalias() = unit * scratch_.head(rows);
        for (std::size_t i = 0; i < points.size(); ++i) free_.segment<3>(3 * i) += points[i].material;
        return {.free = {free_.data(), rows},
                .compliance = {compliance_.data(), rows, rows, Eigen::OuterStride<>(compliance_.outerStride())}};
    }

    StepReport try_step(ContactPoints points, Forces forces) override {
        place(points);
        const auto rows = forces.size();
        const auto q_old = state_.delayed.head(rows);
        auto drive = scratch_.head(rows);
        drive = forces + state_.force.head(rows) - 2.0 * q_old;
        trial_.points.assign(points.begin(), points.end());
        trial_.force.setZero();
        trial_.force.head(rows) = forces;
        trial_.delayed.setZero();
        trial_.delayed.head(rows) = q_old + follow_ * drive;
        trial_.stored = prompt_ * energy_of(trial_.force.head(rows)) + delayed_ * energy_of(trial_.delayed.head(rows));
        // Δq = follow · drive, and τ/Δt = (1 − follow)/(2 follow)
        trial_.damping = state_.damping + follow_ * (1.0 - follow_) * delayed_ * energy_of(drive);
        return {};
    }

    void commit() override {
        state_ = trial_;
        follow_ = 0.0;    // the step is over: nothing creeps before the next predict
    }
    void rollback() override {
        trial_ = state_;
        follow_ = 0.0;
    }
    EnergyReport energy() const override { return {.stored = trial_.stored, .damping = trial_.damping}; }

    Vector3 displacement(const Vector3& material) const override {
        const ContactPoint here{.material = material, .span = Vector3::Zero(), .arclength = 0.0, .tip = true};
        Vector3 sum = Vector3::Zero();
        for (std::size_t i = 0; i < state_.points.size(); ++i) {
            sum += mean_kernel(here, state_.points[i]) *
                   (prompt_ * state_.force.segment<3>(3 * i) + delayed_ * state_.delayed.segment<3>(3 * i));
        }
        return sum;
    }

    Location locate(const Vector3& material) const override {
        const Vector3 half = 0.5 * block_.extent;
        const double depth = -material.z();
        const bool inside = depth >= -surface_tolerance && depth <= block_.extent.z() && std::abs(material.x()) <= half.x() &&
                            std::abs(material.y()) <= half.y();
        return {.layer = inside ? 0 : outside, .depth = depth};
    }

    double entry(const Vector3& from, const Vector3& to) const override {
        constexpr double none = -1.0;
        if (from.z() < 0.0 || to.z() > 0.0 || !(from.z() > to.z())) return none;
        const double fraction = from.z() / (from.z() - to.z());
        return locate(from + fraction * (to - from)).layer == outside ? none : fraction;
    }

private:
    struct State {
        std::vector<ContactPoint> points{};
        VectorX force = VectorX::Zero(3 * max_contacts);      // [N] f; zero beyond the contacts
        VectorX delayed = VectorX::Zero(3 * max_contacts);    // [N] q, the same
        double stored = 0.0;                                  // [J]
        double damping = 0.0;                                 // [J] since the start
    };

    Matrix3 mean_kernel(const ContactPoint& i, const ContactPoint& j) const {
        const int n = i.tip ? 1 : shaft_samples, m = j.tip ? 1 : shaft_samples;
        Matrix3 sum = Matrix3::Zero();
        for (int a = 0; a < n; ++a) {
            for (int b = 0; b < m; ++b) sum += kernel_(i.material + (a + 0.5) / n * i.span - j.material - (b + 0.5) / m * j.span);
        }
        return sum / (n * m);
    }

    // Works out again what a contact that moved has to do with the others. From tick to tick few move: the tip and the piece of
    // shaft behind it.
    void place(ContactPoints points) {
        const std::size_t known = std::min(placed_.size(), points.size());
        placed_.resize(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (i < known && placed_[i].material == points[i].material && placed_[i].span == points[i].span) continue;
            placed_[i] = points[i];
            for (std::size_t j = 0; j < std::max(i + 1, known); ++j) {
                const double own = i == j ? 1.0 + independence : 1.0;
                // Always in this order: a sum taken the other way round would differ in the last bit.
                const Matrix3 mutual = own * mean_kernel(placed_[std::max(i, j)], placed_[std::min(i, j)]);
                unit_.block<3, 3>(3 * i, 3 * j) = mutual;
                unit_.block<3, 3>(3 * j, 3 * i) = mutual;
            }
        }
    }

    double energy_of(const Eigen::Ref<const VectorX>& forces) {    // ½ fᵀCf
        auto moved = moved_.head(forces.size());
        moved.noalias() = unit_.topLeftCorner(forces.size(), forces.size()) * forces;
        return 0.5 * forces.dot(moved);
    }

    TissueSetup block_;
    double prompt_;              // [1/Pa] 1/E₀
    double delayed_;             // [1/Pa] 1/E₁
    double retardation_time_;    // [s] τ
    Kernel kernel_;
    double follow_ = 0.0;    // Δt/(2τ + Δt): how far q follows in a step; zero where no time passes
    std::vector<ContactPoint> placed_;
    MatrixX unit_ = MatrixX(3 * max_contacts, 3 * max_contacts);          // [1/m] C between the placed points
    MatrixX compliance_ = MatrixX(3 * max_contacts, 3 * max_contacts);    // [m/N]
    VectorX free_ = VectorX(3 * max_contacts);                            // [m]
    VectorX scratch_ = VectorX(3 * max_contacts), moved_ = VectorX(3 * max_contacts);
    State state_, trial_;
};

}    // namespace stylet::viscoelastic_half_space

STYLET_PLUGIN(stylet::viscoelastic_half_space::ViscoelasticHalfSpace, "viscoelastic_half_space",
              stylet::viscoelastic_half_space::parameters,
              .summary = "A half-space that creeps under a force and relaxes in a dent",
              .formula =
                  "u = C (f/E0 + q/E1),  tau q' = f - q,  1/E_long_term = 1/E0 + 1/E1\n"
                  "C: mean over both contacts of a regularised Kelvin kernel; of a contact itself (1 - nu^2)/(2 radius)",
              .source =
                  "Christensen 1982 (standard linear solid, correspondence); de Goes and James 2017, eq. (6). Deviation: the "
                  "delayed part of a contact's force goes along where the needle slides",
              .validity =
                  "Small strain, quasi-static, one layer, a Poisson's ratio that does not creep. Only a contact's own "
                  "compliance knows that there is a surface; sides and bottom are not felt")
