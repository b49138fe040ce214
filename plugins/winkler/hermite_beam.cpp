#include "hermite_beam.h"

namespace stylet::winkler {

void add_beam(BandedPencil& pencil, int e, double h) {
    const int i = 2 * e;
    const double h2 = h * h, k = 1.0 / (h2 * h);
    pencil.stiffness(i, i) += 12.0 * k;
    pencil.stiffness(i + 1, i) += 6.0 * h * k;
    pencil.stiffness(i + 1, i + 1) += 4.0 * h2 * k;
    pencil.stiffness(i + 2, i) += -12.0 * k;
    pencil.stiffness(i + 2, i + 1) += -6.0 * h * k;
    pencil.stiffness(i + 2, i + 2) += 12.0 * k;
    pencil.stiffness(i + 3, i) += 6.0 * h * k;
    pencil.stiffness(i + 3, i + 1) += 2.0 * h2 * k;
    pencil.stiffness(i + 3, i + 2) += -6.0 * h * k;
    pencil.stiffness(i + 3, i + 3) += 4.0 * h2 * k;

    const double g = 1.0 / (30.0 * h);
    pencil.geometric(i, i) += 36.0 * g;
    pencil.geometric(i + 1, i) += 3.0 * h * g;
    pencil.geometric(i + 1, i + 1) += 4.0 * h2 * g;
    pencil.geometric(i + 2, i) += -36.0 * g;
    pencil.geometric(i + 2, i + 1) += -3.0 * h * g;
    pencil.geometric(i + 2, i + 2) += 36.0 * g;
    pencil.geometric(i + 3, i) += 3.0 * h * g;
    pencil.geometric(i + 3, i + 1) += -h2 * g;
    pencil.geometric(i + 3, i + 2) += -3.0 * h * g;
    pencil.geometric(i + 3, i + 3) += 4.0 * h2 * g;
}

void add_foundation(BandedPencil& pencil, int e, double h, double begin, double end, double kappa) {
    static constexpr double points[] = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526};
    static constexpr double weights[] = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538};
    const double middle = 0.5 * (begin + end), half = 0.5 * (end - begin);
    for (int point = 0; point < 4; ++point) {
        const double s = middle + half * points[point], t = 1.0 - s;
        const double shape[] = {t * t * (1.0 + 2.0 * s), h * s * t * t, s * s * (3.0 - 2.0 * s), -h * s * s * t};
        const double weight = kappa * h * half * weights[point];
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j <= i; ++j) pencil.stiffness(2 * e + i, 2 * e + j) += weight * shape[i] * shape[j];
    }
}

}    // namespace stylet::winkler
