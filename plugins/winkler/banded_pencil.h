#pragma once

#include <array>

namespace stylet::winkler {

inline constexpr int half_bandwidth = 3;    // of two nodes with a deflection and a slope each
inline constexpr int max_elements = 128;
inline constexpr int max_size = 2 * (max_elements + 1);

/// The lower half of a symmetric matrix of half bandwidth 3. Its memory is its own, for the largest size; only rows that are
/// cleared are ever touched.
class BandMatrix {
public:
    using Row = std::array<double, half_bandwidth + 1>;    // from the diagonal to the left, zero where that ends

    void clear(int size) {
        for (int i = 0; i < size; ++i) row(i).fill(0.0);
    }

    /// j ≤ i ≤ j + 3.
    [[nodiscard]] double& operator()(int i, int j) { return row(i)[static_cast<std::size_t>(i - j)]; }

    [[nodiscard]] Row& row(int i) { return rows_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] const Row& row(int i) const { return rows_[static_cast<std::size_t>(i)]; }

private:
    std::array<Row, max_size> rows_;
};

/// The eigenproblem K x = p G x of two banded matrices, K positive definite, G positive semidefinite and not zero.
class BandedPencil {
public:
    /// `size` ≤ max_size; both matrices zero.
    explicit BandedPencil(int size) : size_(size) {
        stiffness.clear(size);
        geometric.clear(size);
    }

    BandMatrix stiffness;    // K
    BandMatrix geometric;    // G

    /// Takes unknown i out: x(i) = 0 in every eigenvector.
    void fix(int i);

    /// The smallest p, or `bound` where that is smaller still, to the relative `tolerance` or to rounding, whichever is coarser.
    /// Each shifted inverse iteration gives an upper bound, Rayleigh's quotient; the inertia of K − σG says whether an eigenvalue
    /// lies below σ, so it is the smallest that is found, and at least every other step halves the interval around it. Source:
    /// Parlett 1980, The Symmetric Eigenvalue Problem, sections 3.3 (slicing the spectrum) and 4.6 (Rayleigh quotient iteration).
    [[nodiscard]] double smallest_eigenvalue(double bound, double tolerance);

private:
    /// Zeros stand before x(0), where the rows' ends reach to.
    class Vector {
    public:
        [[nodiscard]] double& operator()(int i) { return values_[static_cast<std::size_t>(i + half_bandwidth)]; }
        [[nodiscard]] double operator()(int i) const { return values_[static_cast<std::size_t>(i + half_bandwidth)]; }

    private:
        std::array<double, max_size + half_bandwidth> values_;
    };

    int factorise(double shift);                                        // K − shift·G = L D Lᵀ; how many of D are negative
    void solve(Vector& x) const;                                        // L D Lᵀ x = x, in place
    void multiply_geometric(const Vector& x, Vector& product) const;    // product = G x
    [[nodiscard]] double quotient(double shift);                        // of image_, by the factors of this shift; moves both on
    [[nodiscard]] double dot(const Vector& a, const Vector& b) const;

    int size_;
    BandMatrix factor_;    // L below the diagonal, 1/D on it
    Vector vector_, image_;
};

}    // namespace stylet::winkler
