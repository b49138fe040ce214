#include "banded_pencil.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stylet::winkler {

void BandedPencil::fix(int i) {
    for (int k = 0; k <= half_bandwidth; ++k) {
        if (i - k >= 0) stiffness(i, i - k) = geometric(i, i - k) = 0.0;
        if (i + k < size_) stiffness(i + k, i) = geometric(i + k, i) = 0.0;
    }
    stiffness(i, i) = 1.0;
}

// Row i of L needs the three rows above it alone, which are carried along; above the first row they are those of a unit matrix.
int BandedPencil::factorise(double shift) {
    BandMatrix::Row one{1.0}, two{1.0}, three{1.0};    // 1/D and L of rows i − 1, i − 2, i − 3
    int negatives = 0;
    for (int i = 0; i < size_; ++i) {
        const BandMatrix::Row &k = stiffness.row(i), &g = geometric.row(i);
        const double d3 = k[3] - shift * g[3];    // L(i, j) D(j) of j = i − 3, i − 2, i − 1
        const double d2 = k[2] - shift * g[2] - d3 * two[1];
        const double d1 = k[1] - shift * g[1] - d3 * one[2] - d2 * one[1];
        const double l3 = d3 * three[0], l2 = d2 * two[0], l1 = d1 * one[0];
        double pivot = k[0] - shift * g[0] - d3 * l3 - d2 * l2 - d1 * l1;
        if (pivot == 0.0) pivot = std::numeric_limits<double>::epsilon() * k[0];    // an eigenvalue, to rounding
        negatives += static_cast<int>(pivot < 0.0);
        three = two;
        two = one;
        one = factor_.row(i) = {1.0 / pivot, l1, l2, l3};
    }
    return negatives;
}

void BandedPencil::solve(Vector& x) const {
    double one = 0.0, two = 0.0, three = 0.0;    // x of the unknowns i − 1, i − 2, i − 3
    for (int i = 0; i < size_; ++i) {
        const BandMatrix::Row& l = factor_.row(i);
        const double now = x(i) - l[3] * three - l[2] * two - l[1] * one;
        three = two;
        two = one;
        one = x(i) = now;
    }
    one = two = three = 0.0;    // what the unknowns below take from i, i − 1, i − 2
    for (int i = size_ - 1; i >= 0; --i) {
        const BandMatrix::Row& l = factor_.row(i);
        const double now = x(i) = x(i) * l[0] - one;
        one = two + l[1] * now;
        two = three + l[2] * now;
        three = l[3] * now;
    }
}

void BandedPencil::multiply_geometric(const Vector& x, Vector& product) const {
    double one = 0.0, two = 0.0, three = 0.0;    // what the unknowns below give to i, i − 1, i − 2
    for (int i = size_ - 1; i >= 0; --i) {
        const BandMatrix::Row& g = geometric.row(i);
        product(i) = g[0] * x(i) + g[1] * x(i - 1) + g[2] * x(i - 2) + g[3] * x(i - 3) + one;
        one = two + g[1] * x(i);
        two = three + g[2] * x(i);
        three = g[3] * x(i);
    }
}

double BandedPencil::dot(const Vector& a, const Vector& b) const {
    double sum = 0.0;
    for (int i = 0; i < size_; ++i) sum += a(i) * b(i);
    return sum;
}

double BandedPencil::quotient(double shift) {
    for (int i = 0; i < size_; ++i) vector_(i) = image_(i);
    solve(vector_);
    const double product = dot(vector_, image_);
    multiply_geometric(vector_, image_);
    const double norm = dot(vector_, image_);
    const double scale = 1.0 / std::sqrt(norm);
    for (int i = 0; i < size_; ++i) image_(i) *= scale;
    return shift + product / norm;
}

double BandedPencil::smallest_eigenvalue(double bound, double tolerance) {
    constexpr int most_steps = 200;    // never reached: at least half of them halve the interval
    for (int i = -half_bandwidth; i < 0; ++i) vector_(i) = 0.0;
    // Neither even nor odd, so that it has a part in every mode.
    for (int i = 0; i < size_; ++i) image_(i) = std::fmod(0.6180339887498949 * (i + 1), 1.0);

    double below = 0.0, above = bound;    // of the smallest p
    double estimate = std::numeric_limits<double>::infinity(), shift = 0.5 * bound;
    for (int step = 0; step < most_steps; ++step) {
        const int smaller = factorise(shift);
        if (smaller == 0)
            below = shift;
        else
            above = std::min(above, shift);

        double gained = std::numeric_limits<double>::infinity();
        if (smaller <= 1) {    // with more of them around the shift, the vector would only wander
            const double before = estimate;
            estimate = quotient(shift);
            gained = before - estimate;
            above = std::min(above, estimate);
        }
        if (above - below <= tolerance * above) break;

        // What one step gains is more than the next will, where the vector is that of the smallest p.
        const double middle = 0.5 * (below + above);
        const double aimed = std::min(above - 2.0 * gained, above * (1.0 - 0.5 * tolerance));
        shift = smaller == 0 && aimed > middle ? aimed : middle;
    }
    return above;
}

}    // namespace stylet::winkler
