// Undeformed blocks and their matrices for tests, with a solver that nobody here wrote.
#pragma once

#include "fast/dissection.h"
#include "fast/lanes.h"
#include "fast/rest_matrix.h"
#include "solid/test_solids.h"

#include <Eigen/SparseCholesky>

#include <thread>

namespace stylet::corotational_fem::testing {

inline Motion quasi_static() {
    return {};
}

inline Motion backward_euler(double dt) {
    Motion motion;
    motion.implicit = true;
    motion.dt = dt;
    return motion;
}

inline Motion with_shared_pressure(Motion motion) {
    motion.share_pressure = true;
    return motion;
}

/// 100 × 100 × 50 mm in uneven tetrahedra, held at the bottom. Its upper half is of layer 1.
inline Mesh uneven_block(const Cells& cells) {
    Mesh mesh = jiggled(block(Vector3(0.1, 0.1, 0.05), cells), 0.15 * 0.1 / cells[0], 1);
    for (int e = 0; e < mesh.size(); ++e) mesh.layers[e] = e < mesh.size() / 2 ? 0 : 1;
    return mesh;
}

inline std::vector<Material> alike(const Material& material) {
    return {material, material};
}

inline Eigen::SparseMatrix<double> sparse(const BlockMatrix& a) {
    std::vector<Eigen::Triplet<double>> numbers;
    for (int row = 0; row < a.rows(); ++row) {
        for (int at = a.start[row]; at < a.start[row + 1]; ++at) {
            for (int i = 0; i < 3; ++i) {
                for (int j = 0; j < 3; ++j) numbers.emplace_back(3 * row + i, 3 * a.column[at] + j, a.block[at](i, j));
            }
        }
    }
    Eigen::SparseMatrix<double> result(3 * a.rows(), 3 * a.rows());
    result.setFromTriplets(numbers.begin(), numbers.end());
    return result;
}

/// What Eigen makes of A x = b, in rows.
inline VectorX solution(const BlockMatrix& a, const VectorX& b) {
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(sparse(a));
    return factor.solve(b);
}

/// A newton downward on the nodes at the middle of the top, in rows.
inline VectorX patch_load(const Mesh& mesh, const BlockMatrix& a) {
    VectorX b = VectorX::Zero(3 * a.rows());
    for (int row = 0; row < a.rows(); ++row) {
        const Vector3& x = mesh.nodes[a.mesh_node[row]];
        if (x.z() > -1e-6 && x.head<2>().lpNorm<Eigen::Infinity>() < 0.0105) b[3 * row + 2] = -1.0;
    }
    return b / b.lpNorm<1>();
}

/// From rows to places.
inline VectorX in_places(const Dissection& d, const VectorX& rows) {
    VectorX places(rows.size());
    for (int row = 0; row < d.places(); ++row) places.segment<3>(3 * d.place[row]) = rows.segment<3>(3 * row);
    return places;
}

inline VectorX in_rows(const Dissection& d, const VectorX& places) {
    VectorX rows(places.size());
    for (int row = 0; row < d.places(); ++row) rows.segment<3>(3 * row) = places.segment<3>(3 * d.place[row]);
    return rows;
}

/// Threads that take every so manieth task, from the last one down.
class Threads final : public Workers {
public:
    explicit Threads(int threads) : threads_(threads) {}
    [[nodiscard]] int count() const override { return threads_; }

private:
    void run(int tasks, Call call, void* context) noexcept override {
        std::vector<std::thread> threads;
        for (int t = 0; t < threads_; ++t) {
            threads.emplace_back([=, this] {
                for (int i = tasks - 1 - t; i >= 0; i -= threads_) call(context, i);
            });
        }
        for (std::thread& thread : threads) thread.join();
    }

    int threads_;
};

}    // namespace stylet::corotational_fem::testing
