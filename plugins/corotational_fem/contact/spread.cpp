#include "contact/spread.h"

#include <cmath>

namespace stylet::corotational_fem {
namespace {

constexpr double radius_in_edges = 2.0;      // ρ/h: the least that makes a mesh answer alike everywhere
constexpr double radius_in_needles = 1.6;    // ρ/a at which a ball moves as far as the needle's own kernel says

double shape(double q2) {    // φ, of q²
    return q2 < 1.0 ? (1.0 - q2) * (1.0 - q2) : 0.0;
}

/// w_n/V_n, but for the sum.
double density(const Vector3& node, const Vector3& centre, double radius) {
    const double dx = node.x() - centre.x(), dy = node.y() - centre.y(), rr = dx * dx + dy * dy;
    const double down = node.z() - centre.z(), up = node.z() + centre.z(), scale = 1.0 / (radius * radius);
    return shape((rr + down * down) * scale) + shape((rr + up * up) * scale);
}

}    // namespace

Spread::Spread(const Mesh& mesh, double needle_radius)
    : mesh_(mesh), needle_radius_(needle_radius), grid_(mesh), volumes_(mesh.nodes.size(), 0.0) {
    for (const Tetrahedron& tetrahedron : mesh.tetrahedra) {
        for (const int node : tetrahedron) volumes_[node] += 0.25 * mesh.volume(tetrahedron);
    }
    weights_.reserve(mesh.nodes.size());
}

Balls Spread::balls(const ContactPoint& point) const {
    Balls balls;
    const Vector3 middle = point.material + 0.5 * point.span;
    if (!middle.allFinite()) return balls;
    const double size = grid_.size_at(grid_.inside(middle));
    balls.radius = std::max(radius_in_edges * size, radius_in_needles * needle_radius_);
    const auto add = [&](double fraction) {
        Vector3 centre = grid_.inside(point.material + fraction * point.span);
        centre.z() = std::min(centre.z(), 0.0);
        balls.centres[balls.count++] = centre;
    };
    if (point.tip) {
        add(0.0);
        return balls;
    }
    constexpr double gauss = 0.21132486540518712;    // (1 − 1/√3)/2
    const int rows = static_cast<int>(std::clamp(std::ceil(point.span.norm() / balls.radius), 1.0, Balls::most / 2.0));
    for (int row = 0; row < rows; ++row) {
        add((row + gauss) / rows);
        add((row + 1.0 - gauss) / rows);
    }
    return balls;
}

std::span<const NodeWeight> Spread::of(const ContactPoint& point) {
    weights_.clear();
    const Balls balls = this->balls(point);
    if (balls.count == 0) return weights_;
    Vector3 least = balls.centres[0], greatest = least;
    for (int b = 1; b < balls.count; ++b) {
        least = least.cwiseMin(balls.centres[b]);
        greatest = greatest.cwiseMax(balls.centres[b]);
    }
    least.array() -= balls.radius;
    greatest.array() += balls.radius;

    std::array<double, Balls::most> sums{};
    grid_.for_each_in(least, greatest, [&](int node) {
        for (int b = 0; b < balls.count; ++b)
            sums[b] += volumes_[node] * density(mesh_.nodes[node], balls.centres[b], balls.radius);
    });
    int filled = 0;
    for (int b = 0; b < balls.count; ++b) filled += sums[b] > 0.0 ? 1 : 0;
    grid_.for_each_in(least, greatest, [&](int node) {
        double weight = 0.0;
        for (int b = 0; b < balls.count; ++b) {
            if (sums[b] > 0.0) weight += density(mesh_.nodes[node], balls.centres[b], balls.radius) / sums[b];
        }
        if (weight > 0.0) weights_.push_back({.node = node, .weight = weight * volumes_[node] / filled});
    });
    return weights_;
}

}    // namespace stylet::corotational_fem
