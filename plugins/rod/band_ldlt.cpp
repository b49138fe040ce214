#include "band_ldlt.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stylet::rod {

void BandLdlt::clear() {
    for (auto& column : columns_) column.fill(0.0);
}

int BandLdlt::factor() {
    const int n = rows();
    int negatives = 0;
    for (int j = 0; j < n; ++j) {
        std::array<double, band + 1>& pivot = columns_[j];
        if (pivot[0] == 0.0) pivot[0] = std::numeric_limits<double>::min();    // singular: the solution overflows, as it should
        negatives += pivot[0] < 0.0;
        const int below = std::min(band, n - 1 - j);
        const double inverse = 1.0 / pivot[0];
        for (int k = 1; k <= below; ++k) {
            const double l = pivot[k] * inverse;
            if (l == 0.0) continue;    // bending apart from twisting
            std::array<double, band + 1>& column = columns_[j + k];
            for (int m = k; m <= below; ++m) column[m - k] -= l * pivot[m];
        }
        for (int k = 1; k <= below; ++k) pivot[k] *= inverse;
    }
    return negatives;
}

void BandLdlt::solve(VectorX& b) const {
    const int n = rows();
    for (int j = 0; j < n; ++j) {
        const int below = std::min(band, n - 1 - j);
        for (int k = 1; k <= below; ++k) b[j + k] -= columns_[j][k] * b[j];
    }
    for (int j = n - 1; j >= 0; --j) {
        const int below = std::min(band, n - 1 - j);
        double sum = b[j] / columns_[j][0];
        for (int k = 1; k <= below; ++k) sum -= columns_[j][k] * b[j + k];
        b[j] = sum;
    }
}

void BandLdlt::solve(Columns& b, const std::vector<int>& starts, int count) const {
    if (count == 0) return;
    const int n = rows();
    int active = 0;    // columns that have begun
    for (int j = starts.front(); j < n; ++j) {
        while (active < count && starts[active] <= j) ++active;
        const int below = std::min(band, n - 1 - j);
        const double* row = b.row(j).data();
        for (int k = 1; k <= below; ++k) {
            const double l = columns_[j][k];
            if (l == 0.0) continue;
            double* other = b.row(j + k).data();
            for (int c = 0; c < active; ++c) other[c] -= l * row[c];
        }
    }
    for (int j = n - 1; j >= starts.front(); --j) {
        while (active > 0 && starts[active - 1] > j) --active;
        const int below = std::min(band, n - 1 - j);
        double* row = b.row(j).data();
        const double inverse = 1.0 / columns_[j][0];
        for (int c = 0; c < active; ++c) row[c] *= inverse;
        for (int k = 1; k <= below; ++k) {
            const double l = columns_[j][k];
            if (l == 0.0) continue;
            const double* other = b.row(j + k).data();
            for (int c = 0; c < active; ++c) row[c] -= l * other[c];
        }
    }
}

}    // namespace stylet::rod
