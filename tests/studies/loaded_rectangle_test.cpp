#include "apps/study/loaded_rectangle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

namespace stylet::study {
namespace {

TEST(LoadedRectangle, SinksByThePrintedMeans) {
    // Timoshenko and Goodier 1970, article 139: m of w = m F(1 − ν²)/(E √(area)), printed to two digits, at a/b = 1 to 100.
    struct Row {
        double ratio, m;
    };
    constexpr Row table[] = {{1.0, 0.95}, {1.5, 0.94}, {2.0, 0.92}, {3.0, 0.88}, {5.0, 0.82}, {10.0, 0.71}, {100.0, 0.37}};
    constexpr double digits = 0.005;
    for (const Row& row : table) {
        const double side = 1.0 / std::sqrt(row.ratio);    // the area is 1
        const double m = mean_displacement(row.ratio * side, side, 1.0, 1.0, 0.0);
        std::printf("a/b = %g: m = %.4f, printed %.2f\n", row.ratio, m, row.m);
        EXPECT_NEAR(m, row.m, digits);
    }
    EXPECT_NEAR(mean_displacement(1.0, 1.0, 1.0, 1.0, 0.0), 0.9464, 0.5e-4);
}

TEST(LoadedRectangle, IsTheMeanOfPointLoads) {
    // 1/(πE r) between the middles of n by n cells, and a square's own mean in place of r = 0.
    constexpr double a = 1.0, b = 0.4;
    constexpr int n = 200;
    double sum = 0.0;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            if (i == 0 && j == 0) continue;
            const int pairs = (i == 0 ? n : 2 * (n - i)) * (j == 0 ? n : 2 * (n - j));
            sum += pairs / std::hypot(a * i / n, b * j / n) / std::numbers::pi;
        }
    }
    const double cell = mean_displacement(a / n, b / n, 1.0, 1.0, 0.0);
    const double mean = sum / std::pow(n, 4) + cell / (n * n);
    const double formula = mean_displacement(a, b, 1.0, 1.0, 0.0);
    std::printf("1 by 0.4: %.6f by point loads, %.6f by the formula\n", mean, formula);
    constexpr double by_cells = 1e-3;    // relative; neighbouring cells are no points, which falls with 1/n
    EXPECT_NEAR(mean, formula, by_cells * formula);
}

TEST(LoadedRectangle, IsTheSameFromBothSidesAndGrowsWithTheForce) {
    EXPECT_DOUBLE_EQ(mean_displacement(0.02, 0.03, 2.0, 25e3, 0.49), mean_displacement(0.03, 0.02, 2.0, 25e3, 0.49));
    EXPECT_DOUBLE_EQ(mean_displacement(0.02, 0.03, 2.0, 25e3, 0.49), 2.0 * mean_displacement(0.02, 0.03, 1.0, 25e3, 0.49));
    EXPECT_DOUBLE_EQ(mean_displacement(0.02, 0.03, 1.0, 25e3, 0.5), 0.75 * mean_displacement(0.02, 0.03, 1.0, 25e3, 0.0));
}

}    // namespace
}    // namespace stylet::study
