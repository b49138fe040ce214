// Dense problems of a chosen inertia, the same on every machine that draws the same seed.
#pragma once

#include <stylet/types.h>

#include <limits>
#include <random>

namespace stylet::core {

class Draw {
public:
    explicit Draw(unsigned seed) : engine_(seed) {}

    double between(double least, double greatest) { return std::uniform_real_distribution(least, greatest)(engine_); }
    int below(int count) { return std::uniform_int_distribution(0, count - 1)(engine_); }

    MatrixX matrix(int rows, int columns) {
        return MatrixX::NullaryExpr(rows, columns, [this] { return between(-1.0, 1.0); });
    }

    /// n × n, symmetric, `negatives` of its eigenvalues in [−2, −½], the others in [½, 2].
    MatrixX symmetric(int n, int negatives) {
        if (n == 0) return MatrixX(0, 0);
        const MatrixX turned = Eigen::HouseholderQR<MatrixX>(matrix(n, n)).householderQ();
        VectorX eigenvalues(n);
        for (int i = 0; i < n; ++i) eigenvalues[i] = (i < negatives ? -1.0 : 1.0) * between(0.5, 2.0);
        const MatrixX product = turned * eigenvalues.asDiagonal() * turned.transpose();
        return 0.5 * (product + product.transpose());
    }

private:
    std::mt19937_64 engine_;
};

/// A whose first m rows have this inertia and whose Schur complement on the others is `schur`.
inline MatrixX with_schur_complement(Draw& draw, int m, int negatives, const MatrixX& schur) {
    if (m == 0) return schur;
    const auto boxed = static_cast<int>(schur.rows());
    MatrixX a(m + boxed, m + boxed);
    a.topLeftCorner(m, m) = draw.symmetric(m, negatives);
    a.bottomLeftCorner(boxed, m) = draw.matrix(boxed, m);
    a.topRightCorner(m, boxed) = a.bottomLeftCorner(boxed, m).transpose();
    a.bottomRightCorner(boxed, boxed) =
        schur + a.bottomLeftCorner(boxed, m) * a.topLeftCorner(m, m).fullPivLu().solve(a.topRightCorner(m, boxed));
    return a;
}

/// The lower triangle alone: whoever reads above it reads nonsense.
inline MatrixX lower_triangle(const MatrixX& a) {
    MatrixX lower = MatrixX::Constant(a.rows(), a.cols(), std::numeric_limits<double>::quiet_NaN());
    lower.triangularView<Eigen::Lower>() = a;
    return lower;
}

inline int negative_eigenvalues(const MatrixX& a) {
    if (a.size() == 0) return 0;
    const VectorX eigenvalues = Eigen::SelfAdjointEigenSolver<MatrixX>(a, Eigen::EigenvaluesOnly).eigenvalues();
    return static_cast<int>((eigenvalues.array() < 0.0).count());
}

}    // namespace stylet::core
