#include "solid/solid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stylet::corotational_fem {

namespace {

// Two stretches that add up to less than this count as this much: an element so flat twists as stiffly as anything may.
constexpr double least_across = 1e-3;

Eigen::Matrix<double, 3, 4> gradients_of(const Matrix3& edges) {
    Eigen::Matrix<double, 3, 4> gradients;
    gradients.rightCols<3>() = edges.inverse().transpose();
    gradients.col(0) = -gradients.rightCols<3>().rowwise().sum();
    return gradients;
}

}    // namespace

Solid::Solid(const Mesh& mesh, std::span<const Material> materials, bool share_pressure)
    : mesh_(mesh),
      polars_(mesh.tetrahedra.size(), Polar(Matrix3::Identity())),
      strains_(mesh.tetrahedra.size()),
      dilatations_(mesh.tetrahedra.size()) {
    for (int e = 0; e < mesh.size(); ++e) {
        const Matrix3 edges = mesh.edges(mesh.tetrahedra[e]);
        const Material& material = materials[mesh.layers[e]];
        shapes_.push_back({gradients_of(edges), edges.determinant() / 6.0, material.shear_modulus, material.lame});
    }
    if (!share_pressure) return;
    patches_.resize(*std::max_element(mesh.patches.begin(), mesh.patches.end()) + 1);
    for (int e = 0; e < mesh.size(); ++e) {
        Patch& patch = patches_[mesh.patches[e]];
        patch.volume += shapes_[e].volume;
        patch.tetrahedra.push_back(e);
        patch.nodes.insert(patch.nodes.end(), mesh.tetrahedra[e].begin(), mesh.tetrahedra[e].end());
    }
    for (Patch& patch : patches_) {
        std::sort(patch.nodes.begin(), patch.nodes.end());
        patch.nodes.erase(std::unique(patch.nodes.begin(), patch.nodes.end()), patch.nodes.end());
    }
}

Matrix3 Solid::gradient_of(const VectorX& u, int tetrahedron) const {
    Matrix3 gradient = Matrix3::Zero();
    for (int a = 0; a < 4; ++a) {
        gradient += u.segment<3>(3 * mesh_.tetrahedra[tetrahedron][a]) * shapes_[tetrahedron].gradients.col(a).transpose();
    }
    return gradient;
}

void Solid::measure(const VectorX& u) {
    for (int e = 0; e < mesh_.size(); ++e) {
        const Matrix3 deformation = Matrix3::Identity() + gradient_of(u, e);
        polars_[e] = Polar(deformation);
        strains_[e] = deformation - polars_[e].rotation();
        dilatations_[e] = polars_[e].stretches.sum() - 3.0;
    }
    average_dilatations();
}

void Solid::average_dilatations() {
    for (const Patch& patch : patches_) {
        double sum = 0.0;    // [m³]
        for (const int e : patch.tetrahedra) sum += shapes_[e].volume * dilatations_[e];
        for (const int e : patch.tetrahedra) dilatations_[e] = sum / patch.volume;
    }
}

double Solid::strain(const VectorX& u, VectorX& forces) {
    measure(u);
    inverted_ = std::any_of(polars_.begin(), polars_.end(), [](const Polar& polar) { return polar.stretches[2] < 0.0; });
    double energy = 0.0;
    for (int e = 0; e < mesh_.size(); ++e) {
        const auto& [gradients, volume, shear_modulus, lame] = shapes_[e];
        const double theta = dilatations_[e];
        energy += volume * (shear_modulus * strains_[e].squaredNorm() + 0.5 * lame * theta * theta);
        push(e, 2.0 * shear_modulus * strains_[e] + lame * theta * polars_[e].rotation(), forces);
    }
    return energy;
}

double Solid::damp(const VectorX& u, const VectorX& from, double rate, VectorX& forces) {
    measure(from);
    for (int e = 0; e < mesh_.size(); ++e) {
        const Matrix3 turned = polars_[e].rotation().transpose() * (gradient_of(u, e) - gradient_of(from, e));
        strains_[e] = 0.5 * (turned + turned.transpose());
        dilatations_[e] = turned.trace();
    }
    average_dilatations();
    double lost = 0.0;
    for (int e = 0; e < mesh_.size(); ++e) {
        const auto& [gradients, volume, shear_modulus, lame] = shapes_[e];
        const double theta = dilatations_[e];
        lost += rate * volume * (2.0 * shear_modulus * strains_[e].squaredNorm() + lame * theta * theta);
        const Matrix3 stress = 2.0 * shear_modulus * strains_[e] + lame * theta * Matrix3::Identity();
        push(e, rate * polars_[e].rotation() * stress, forces);
    }
    return lost;
}

// f_a = V P ∇N_a
void Solid::push(int tetrahedron, const Matrix3& stress, VectorX& forces) const {
    const Shape& shape = shapes_[tetrahedron];
    for (int a = 0; a < 4; ++a) {
        forces.segment<3>(3 * mesh_.tetrahedra[tetrahedron][a]) += shape.volume * stress * shape.gradients.col(a);
    }
}

void Solid::stiffen(const VectorX& u, Twists twists, Tangent& tangent) {
    measure(u);
    for (int e = 0; e < mesh_.size(); ++e) stiffen_own(e, 1.0, twists, tangent);
    for (const Patch& patch : patches_) stiffen_shared(patch, 1.0, tangent);
}

// The tangent of a tetrahedron that is turned and not strained is that of linear elasticity in its frame.
void Solid::stiffen_damper(const VectorX& from, double rate, Tangent& tangent) {
    measure(from);
    for (Polar& polar : polars_) polar.stretches.setOnes();
    std::fill(dilatations_.begin(), dilatations_.end(), 0.0);
    for (int e = 0; e < mesh_.size(); ++e) stiffen_own(e, rate, Twists::exact, tangent);
    for (const Patch& patch : patches_) stiffen_shared(patch, rate, tangent);
}

// K_ab = V [2μ ∇N_a·∇N_b I + λ (R∇N_a)(R∇N_b)ᵀ + Σ_k (λθ − 2μ) 2/(s_i + s_j) (t_k∇N_a)(t_k∇N_b)ᵀ]
void Solid::stiffen_own(int tetrahedron, double factor, Twists twists, Tangent& tangent) const {
    const auto& [gradients, volume, shear_modulus, lame] = shapes_[tetrahedron];
    const Polar& polar = polars_[tetrahedron];
    using Turned = Eigen::Matrix<double, 3, 4>;
    const Turned swelling = polar.rotation() * gradients;
    Turned twisting[3];
    double twist_stiffness[3];
    for (int k = 0; k < 3; ++k) {
        twisting[k] = polar.twist(k) * gradients;
        const double pull = lame * dilatations_[tetrahedron] - 2.0 * shear_modulus;
        twist_stiffness[k] = 2.0 * pull / std::max(polar.across(k), least_across);
        if (twists == Twists::definite) twist_stiffness[k] = std::max(twist_stiffness[k], -2.0 * shear_modulus);
    }
    const Tetrahedron& nodes = mesh_.tetrahedra[tetrahedron];
    for (int a = 0; a < 4; ++a) {
        for (int b = 0; b < 4; ++b) {
            Matrix3 block = 2.0 * shear_modulus * gradients.col(a).dot(gradients.col(b)) * Matrix3::Identity();
            if (patches_.empty()) block += lame * swelling.col(a) * swelling.col(b).transpose();
            for (int k = 0; k < 3; ++k) block += twist_stiffness[k] * twisting[k].col(a) * twisting[k].col(b).transpose();
            tangent.add(nodes[a], nodes[b], factor * volume * block);
        }
    }
}

// K_ab = λ/V g_a g_bᵀ,  g_a = ∂(V θ̄)/∂u_a = Σ_e V_e R_e∇N_a
void Solid::stiffen_shared(const Patch& patch, double factor, Tangent& tangent) const {
    Eigen::Matrix<double, 3, Eigen::Dynamic> swelling = Eigen::Matrix<double, 3, Eigen::Dynamic>::Zero(3, patch.nodes.size());
    for (const int e : patch.tetrahedra) {
        const Eigen::Matrix<double, 3, 4> own = shapes_[e].volume * polars_[e].rotation() * shapes_[e].gradients;
        for (int a = 0; a < 4; ++a) {
            const auto at = std::lower_bound(patch.nodes.begin(), patch.nodes.end(), mesh_.tetrahedra[e][a]);
            swelling.col(at - patch.nodes.begin()) += own.col(a);
        }
    }
    const double bulk = factor * shapes_[patch.tetrahedra.front()].lame / patch.volume;
    for (std::size_t a = 0; a < patch.nodes.size(); ++a) {
        for (std::size_t b = 0; b < patch.nodes.size(); ++b) {
            tangent.add(patch.nodes[a], patch.nodes[b], bulk * swelling.col(a) * swelling.col(b).transpose());
        }
    }
}

double Solid::rounding() const {
    constexpr double units = 64.0;    // in the last place: two or three of a strain, times the 24 tetrahedra around a node
    double greatest = 0.0;
    for (const auto& [gradients, volume, shear_modulus, lame] : shapes_) {
        greatest = std::max(greatest, (2.0 * shear_modulus + lame) * volume * gradients.colwise().norm().maxCoeff());
    }
    return units * std::numeric_limits<double>::epsilon() * greatest;
}

}    // namespace stylet::corotational_fem
