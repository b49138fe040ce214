#include "banded_pencil.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stylet::winkler {

BandedPencil::BandedPencil(int size) : size_(size) {
    stiffness.clear(size);
    geometric.clear(size);
}

void BandedPencil::fix(int i) {
    for (int k = 0; k <= half_bandwidth; ++k) {
        if (i - k >= 0) stiffness(i, i - k) = geometric(i, i - k) = 0.0;
        if (i + k < size_) stiffness(i + k, i) = geometric(i + k, i) = 0.0;
    }
    stiffness(i, i) = 1.0;
}

int BandedPencil::factorise(double shift) {
    int negatives = 0;
    for (int i = 0; i < size_; ++i) {
        const int first = std::max(0, i - half_bandwidth);
        double pivot = stiffness(i, i) - shift * geometric(i, i);
        std::array<double, half_bandwidth> scaled;    // L(i, j) D(j), from the left
        for (int j = first; j < i; ++j) {
            double sum = stiffness(i, j) - shift * geometric(i, j);
            for (int k = first; k < j; ++k) sum -= scaled[static_cast<std::size_t>(k - first)] * factor_(j, k);
            scaled[static_cast<std::size_t>(j - first)] = sum;
            factor_(i, j) = sum * factor_(j, j);
            pivot -= sum * factor_(i, j);
        }
        if (pivot == 0.0) pivot = std::numeric_limits<double>::epsilon() * stiffness(i, i);    // an eigenvalue, to rounding
        negatives += static_cast<int>(pivot < 0.0);
        factor_(i, i) = 1.0 / pivot;
    }
    return negatives;
}

void BandedPencil::solve(Vector& x) const {
    for (int i = 0; i < size_; ++i)
        for (int j = std::max(0, i - half_bandwidth); j < i; ++j) x[i] -= factor_(i, j) * x[j];
    for (int i = 0; i < size_; ++i) x[i] *= factor_(i, i);
    for (int i = size_ - 1; i >= 0; --i)
        for (int j = std::max(0, i - half_bandwidth); j < i; ++j) x[j] -= factor_(i, j) * x[i];
}

void BandedPencil::multiply_geometric(const Vector& x, Vector& product) const {
    for (int i = 0; i < size_; ++i) {
        product[i] = geometric(i, i) * x[i];
        for (int j = std::max(0, i - half_bandwidth); j < i; ++j) {
            product[i] += geometric(i, j) * x[j];
            product[j] += geometric(i, j) * x[i];
        }
    }
}

double BandedPencil::dot(const Vector& a, const Vector& b) const {
    double sum = 0.0;
    for (int i = 0; i < size_; ++i) sum += a[i] * b[i];
    return sum;
}

double BandedPencil::smallest_eigenvalue(double tolerance) {
    constexpr int most_steps = 100;    // half of them halve the interval: never reached
    // Neither even nor odd, so that it has a part in every mode.
    for (int i = 0; i < size_; ++i) image_[i] = std::fmod(0.6180339887498949 * (i + 1), 1.0);

    double below = 0.0, above = std::numeric_limits<double>::infinity();    // bounds of the smallest p
    double quotient = above, shift = 0.0;
    for (int step = 0; step < most_steps; ++step) {
        const bool is_below = factorise(shift) == 0;
        if (is_below)
            below = shift;
        else
            above = std::min(above, shift);

        vector_ = image_;
        solve(vector_);
        const double before = quotient;
        const double numerator = dot(vector_, image_);
        multiply_geometric(vector_, image_);
        const double norm = dot(vector_, image_);
        quotient = shift + numerator / norm;
        above = std::min(above, quotient);
        if (above - below <= tolerance * above) break;

        const double size = 1.0 / std::sqrt(norm);
        for (int i = 0; i < size_; ++i) image_[i] *= size;
        // What the last step gained is more than the next will, where the vector is that of the smallest p.
        const double middle = 0.5 * (below + above);
        const double aimed = std::min(above - 2.0 * (before - quotient), above * (1.0 - 0.5 * tolerance));
        shift = is_below && aimed > middle ? aimed : middle;
    }
    return above;
}

}    // namespace stylet::winkler
