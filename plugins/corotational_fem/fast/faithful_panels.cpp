#include "fast/faithful_panels.h"

#include <cmath>

namespace stylet::corotational_fem {

namespace {

constexpr double little = 0.2;    // of an error, left by a correction
constexpr int rounds = 8;         // of the power method

// A x, rows both.
VectorX product(const BlockMatrix& a, const VectorX& x) {
    VectorX b = VectorX::Zero(x.size());
    for (int row = 0; row < a.rows(); ++row) {
        for (int at = a.start[row]; at < a.start[row + 1]; ++at)
            b.segment<3>(3 * row) += a.block[at] * x.segment<3>(3 * a.column[at]);
    }
    return b;
}

// P b, rows both.
VectorX solution(Panels& panels, const VectorX& b, Workers& workers) {
    const Dissection& d = panels.dissection();
    std::vector<Float4> rhs(d.places() + 1), x(d.places() + 1);
    const double scale = b.lpNorm<Eigen::Infinity>();
    for (int place = 0; place < d.places(); ++place) {
        const Eigen::Vector3f f = (b.segment<3>(3 * d.row[place]) / scale).cast<float>();
        rhs[place] = {f.x(), f.y(), f.z(), 0.0F};
    }
    panels.solve(rhs.data(), x.data(), workers);
    VectorX result(b.size());
    for (int place = 0; place < d.places(); ++place) {
        result.segment<3>(3 * d.row[place]) = scale * Vector3(x[place].x, x[place].y, x[place].z);
    }
    return result;
}

}    // namespace

double error_left(Panels& panels, const BlockMatrix& matrix, Workers& workers) {
    VectorX error(3 * matrix.rows());
    for (Eigen::Index i = 0; i < error.size(); ++i) error[i] = std::sin(static_cast<double>(i * i));    // a bit of everything
    double left = 0.0;
    for (int round = 0; round < rounds; ++round) {
        error.normalize();
        error -= solution(panels, product(matrix, error), workers);
        left = error.norm();
        if (!(left > 0.0)) break;
    }
    return left;
}

std::unique_ptr<Panels> faithful_panels(const Factor& factor, const BlockMatrix& matrix, InstructionSet set, Workers& workers) {
    auto panels = std::make_unique<Panels>(factor, smallest_storage(set), set);
    if (panels->storage() == Storage::single || error_left(*panels, matrix, workers) < little) return panels;
    return std::make_unique<Panels>(factor, Storage::single, set);
}

}    // namespace stylet::corotational_fem
