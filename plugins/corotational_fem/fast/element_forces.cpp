#include "fast/element_forces.h"

#include "fast/shares.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace stylet::corotational_fem {

namespace {

int free_nodes(const Mesh& mesh) {
    return static_cast<int>(std::count(mesh.fixed.begin(), mesh.fixed.end(), char{0}));
}

// Tetrahedra in the order of their first node, so that neighbours in memory are neighbours in the mesh.
std::vector<int> sorted(const Mesh& mesh, std::span<const int> places) {
    std::vector<int> order(mesh.size());
    std::iota(order.begin(), order.end(), 0);
    const auto first = [&](int tetrahedron) {
        const Tetrahedron& nodes = mesh.tetrahedra[tetrahedron];
        return std::min({places[nodes[0]], places[nodes[1]], places[nodes[2]], places[nodes[3]]});
    };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return first(a) < first(b); });
    return order;
}

struct Shape {
    Matrix3 gradients;    // [1/m] ∇N of the corners 1 to 3, one a column
    double volume;        // [m³]
};

Shape shape_of(const Mesh& mesh, int tetrahedron) {
    const Matrix3 edges = mesh.edges(mesh.tetrahedra[tetrahedron]);
    return {edges.inverse().transpose(), edges.determinant() / 6.0};
}

std::vector<ElementBatch> batches_of(const Mesh& mesh, std::span<const Material> materials, std::span<const int> places,
                                     std::span<const int> order) {
    ElementBatch empty{};
    for (auto& nodes : empty.nodes) std::fill(std::begin(nodes), std::end(nodes), free_nodes(mesh));
    std::vector<ElementBatch> batches((order.size() + lanes - 1) / lanes, empty);
    for (int k = 0; k < static_cast<int>(order.size()); ++k) {
        ElementBatch& batch = batches[k / lanes];
        const int lane = k % lanes;
        const Shape shape = shape_of(mesh, order[k]);
        const Material& material = materials[mesh.layers[order[k]]];
        for (int i = 0; i < 4; ++i) batch.nodes[i][lane] = places[mesh.tetrahedra[order[k]][i]];
        for (int i = 0; i < 3; ++i) {
            for (int c = 0; c < 3; ++c) batch.gradients[i][c][lane] = static_cast<float>(shape.gradients(c, i));
        }
        batch.shear[lane] = static_cast<float>(2.0 * material.shear_modulus * shape.volume);
        batch.lame[lane] = static_cast<float>(material.lame * shape.volume);
    }
    return batches;
}

// Of each corner force, in the order in which they lie in memory, the place it acts on.
std::vector<int> corner_places(const std::vector<ElementBatch>& batches) {
    std::vector<int> places(batches.size() * 4 * lanes);
    for (std::size_t b = 0; b < batches.size(); ++b) {
        for (int i = 0; i < 4; ++i) {
            for (int lane = 0; lane < lanes; ++lane) places[(4 * b + i) * lanes + slot_of(lane)] = batches[b].nodes[i][lane];
        }
    }
    return places;
}

}    // namespace

ElementForces::ElementForces(const Mesh& mesh, std::span<const Material> materials, std::span<const int> places,
                             bool share_pressure, bool damped, Workers& workers, InstructionSet set)
    : kernels_(element_kernels(set)),
      workers_(workers),
      batches_(batches_of(mesh, materials, places, sorted(mesh, places))),
      corner_forces_(batches_.size()),
      gather_(corner_places(batches_), free_nodes(mesh)) {
    if (damped) start_rotations_.resize(batches_.size());
    if (share_pressure) group(mesh, sorted(mesh, places));
    if (share_pressure && damped) swellings_.resize(batches_.size());
}

void ElementForces::group(const Mesh& mesh, std::span<const int> order) {
    rotations_.resize(batches_.size());
    dilatations_.resize(batches_.size());
    std::vector<std::vector<int>> patches(*std::max_element(mesh.patches.begin(), mesh.patches.end()) + 1);
    for (int k = 0; k < static_cast<int>(order.size()); ++k) patches[mesh.patches[order[k]]].push_back(k);
    patches_.push_back(0);
    for (const std::vector<int>& patch : patches) {
        double volume = 0.0;    // [m³]
        for (const int k : patch) volume += shape_of(mesh, order[k]).volume;
        for (const int k : patch) {
            const double part = shape_of(mesh, order[k]).volume / volume;
            members_.push_back({k / lanes, k % lanes, static_cast<float>(part)});
        }
        patches_.push_back(static_cast<int>(members_.size()));
    }
}

ElementSums ElementForces::strain(const Float4* u, Float4* forces) {
    ElementPass pass;
    pass.u = u;
    return run(pass, {kernels_.measure, patches_.empty() ? kernels_.strain : kernels_.push}, forces);
}

ElementSums ElementForces::start(const Float4* u, Float4* forces) {
    ElementPass pass;
    pass.u = u;
    return run(pass, {kernels_.measure, patches_.empty() ? kernels_.strain_started : kernels_.push_started}, forces);
}

ElementSums ElementForces::strain(const Float4* u, const Float4* from, double rate, Float4* forces) {
    ElementPass pass;
    pass.u = u;
    pass.from = from;
    pass.rate = static_cast<float>(rate);
    return run(pass, {kernels_.measure_damped, patches_.empty() ? kernels_.strain_damped : kernels_.push_damped}, forces);
}

ElementSums ElementForces::run(ElementPass pass, const Kernels& kernels, Float4* forces) {
    pass.batches = batches_.data();
    pass.forces = corner_forces_.data();
    pass.start_rotations = start_rotations_.data();
    pass.rotations = rotations_.data();
    pass.dilatations = dilatations_.data();
    pass.swellings = swellings_.data();
    const auto each_share = [&](auto&& work) {
        const int batches = static_cast<int>(batches_.size());
        workers_.each(tasks, [&](int task) { work(task, share_start(batches, task), share_start(batches, task + 1)); });
    };
    std::array<bool, tasks> inverted{};
    if (!patches_.empty()) {
        each_share([&](int task, int first, int last) { inverted[task] = kernels.measure(pass, first, last); });
        average(dilatations_);
        if (kernels.measure == kernels_.measure_damped) average(swellings_);
    }
    std::array<ElementSums, tasks> parts;
    each_share([&](int task, int first, int last) { parts[task] = kernels.strain(pass, first, last); });
    gather_.sum(&corner_forces_.data()->of[0][0], forces, workers_);
    ElementSums sums;
    sums.inverted = std::any_of(inverted.begin(), inverted.end(), [](bool each) { return each; });
    for (const ElementSums& part : parts) {
        sums.inverted = sums.inverted || part.inverted;
        sums.elastic += part.elastic;
        sums.dissipated += part.dissipated;
    }
    return sums;
}

// Over each patch.
void ElementForces::average(std::vector<BatchDilatations>& dilatations) {
    const int patches = static_cast<int>(patches_.size()) - 1;
    workers_.each(tasks, [&](int task) {
        for (int p = share_start(patches, task); p < share_start(patches, task + 1); ++p) {
            const std::span<const Member> patch(&members_[patches_[p]], patches_[p + 1] - patches_[p]);
            float mean = 0.0F;
            for (const auto& [batch, lane, weight] : patch) mean += weight * dilatations[batch].theta[lane];
            for (const auto& [batch, lane, weight] : patch) dilatations[batch].theta[lane] = mean;
        }
    });
}

}    // namespace stylet::corotational_fem
