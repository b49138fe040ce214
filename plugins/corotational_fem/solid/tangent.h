// A sparse symmetric matrix over the free nodes of a mesh.
#pragma once

#include "mesh/mesh.h"

#include <Eigen/SparseCore>

#include <span>
#include <vector>

namespace stylet::corotational_fem {

/// Couples every two free nodes of a tetrahedron, or of a patch where those share their pressure. Its pattern is made once.
class Tangent {
public:
    Tangent(const Mesh& mesh, bool share_pressure);

    [[nodiscard]] int free_nodes() const { return static_cast<int>(nodes_.size()); }
    [[nodiscard]] int place(int node) const { return places_[node]; }         // among the free nodes, −1: held
    [[nodiscard]] const std::vector<int>& nodes() const { return nodes_; }    // of the mesh, of each free one

    /// Lower triangle, 3 rows a free node.
    [[nodiscard]] const Eigen::SparseMatrix<double>& matrix() const { return matrix_; }

    void clear() { matrix_.coeffs().setZero(); }

    /// Adds K_ab (3 × 3) of two mesh nodes. Of the two halves (a, b) and (b, a) only one is kept: hand in both, or that one.
    void add(int a, int b, const Matrix3& block);

private:
    std::vector<int> places_, nodes_;
    Eigen::SparseMatrix<double> matrix_;
};

}    // namespace stylet::corotational_fem
