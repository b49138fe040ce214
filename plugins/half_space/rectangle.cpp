#include "rectangle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stylet::half_space {

namespace {

using std::numbers::pi;

constexpr double point = 1e-12;    // [m] no depth is smaller, so that logarithms stay finite at a rectangle's edges

// ∬ X/(R(R + D)) dY: the same as atan(Y/X) − atan(DY/XR), where nothing cancels.
double angle(double X, double Y, double D, double R) {
    return std::atan2(X * Y * (X * X + Y * Y) / (R + D), X * X * R + Y * Y * D);
}

// Every ∬ dX dY of the header at one corner. What depends on X or on Y alone drops out of the sum over the corners.
Matrix3 at_corner(double nu, double X, double Y, double z, double b) {
    const double D = std::max(z + b, point), R = std::sqrt(X * X + Y * Y + D * D);
    const double ln_x = std::asinh(X / std::hypot(Y, D)), ln_y = std::asinh(Y / std::hypot(X, D)), ln_z = std::log(R + D);
    const double ax = angle(X, Y, D, R), ay = angle(Y, X, D, R);
    const double c = 1.0 - 2.0 * nu;
    const double inverse = X * ln_y + Y * ln_x - D * (ax + ay);    // ∬ 1/R
    const double xx = 2.0 * inverse - 2.0 * nu * X * ln_y + (b - c * D) * ax;
    const double yy = 2.0 * inverse - 2.0 * nu * Y * ln_x + (b - c * D) * ay;
    const double xy = -2.0 * nu * R + (b - c * D) * ln_z;
    const double zz = 2.0 * (1.0 - nu) * inverse + z * (ax + ay);
    const double odd_x = c * (Y * ln_z + D * ln_y + X * ax), odd_y = c * (X * ln_z + D * ln_x + Y * ay);
    Matrix3 u;
    u << xx, xy, z * ln_y + odd_x,    //
        xy, yy, z * ln_x + odd_y,     //
        z * ln_y - odd_x, z * ln_x - odd_y, zz;
    return u;
}

// Sixteen terms of the size of the distance cubed leave something of the size of area²/distance.
using Long = long double;

// asinh(v/|u|), where u² times it is still zero at u = 0.
Long slant(Long v, Long u) {
    return u == 0.0L ? 0.0L : std::asinh(v / std::abs(u));
}

Long angle(Long u, Long v) {
    return v == 0.0L ? 0.0L : std::atan(u / v);
}

// ∬∬ du² dv² of what on the surface depends on (u, v) alone, r² = u² + v².
struct Corner {
    Long u, v, r;

    [[nodiscard]] Long inverse() const {    // of 1/r
        return (u * u * v * slant(v, u) + u * v * v * slant(u, v)) / 2.0L - r * r * r / 6.0L;
    }
    [[nodiscard]] Long along_v() const {    // of v²/r³
        return u * u * (v * slant(v, u) - r) / 2.0L + r * r * r / 6.0L;
    }
    [[nodiscard]] Long along_u() const { return Corner{v, u, r}.along_v(); }
    [[nodiscard]] Long across() const {    // of uv/r³
        return -(2.0L * u * v * r + u * u * u * slant(v, u) + v * v * v * slant(u, v)) / 6.0L;
    }
    [[nodiscard]] Long odd_u() const {    // of u/r²
        if (r == 0.0L) return 0.0L;
        return ((3.0L * u * v * v - u * u * u) * std::log(r) + v * v * v * angle(u, v) + 3.0L * u * u * v * angle(v, u)) / 6.0L;
    }
    [[nodiscard]] Long odd_v() const { return Corner{v, u, r}.odd_u(); }
};

}    // namespace

Matrix3 response(double poisson_ratio, const Rectangle& loaded, const Vector3& x, double blur) {
    const double z = std::max(0.0, -x.z());
    Matrix3 sum = Matrix3::Zero();
    for (const double i : {1.0, -1.0}) {
        for (const double j : {1.0, -1.0}) {
            const double X = x.x() - loaded.x + i * loaded.half_x, Y = x.y() - loaded.y + j * loaded.half_y;
            sum += i * j * at_corner(poisson_ratio, X, Y, z, blur);
        }
    }
    return (1.0 + poisson_ratio) / (2.0 * pi * loaded.area()) * sum;
}

Matrix3 mean_response(double poisson_ratio, const Rectangle& loaded, const Rectangle& moved) {
    Long inverse = 0.0L, along_x = 0.0L, along_y = 0.0L, across = 0.0L, odd_x = 0.0L, odd_y = 0.0L;
    for (int corner = 0; corner < 16; ++corner) {
        const auto side = [corner](int bit) { return (corner >> bit & 1) != 0 ? 1.0L : -1.0L; };
        const Long u = Long{moved.x} - loaded.x + side(0) * moved.half_x + side(1) * loaded.half_x;
        const Long v = Long{moved.y} - loaded.y + side(2) * moved.half_y + side(3) * loaded.half_y;
        const Corner at{u, v, std::hypot(u, v)};
        const Long sign = side(0) * side(1) * side(2) * side(3);
        inverse += sign * at.inverse();
        along_x += sign * at.along_u();
        along_y += sign * at.along_v();
        across += sign * at.across();
        odd_x += sign * at.odd_u();
        odd_y += sign * at.odd_v();
    }
    const Long nu = poisson_ratio, c = 1.0L - 2.0L * nu;
    const Long scale = (1.0L + nu) / (2.0L * std::numbers::pi_v<Long> * loaded.area() * moved.area());
    const auto value = [scale](Long sum) { return static_cast<double>(scale * sum); };
    Matrix3 u;
    u << value(2.0L * (inverse - nu * along_y)), value(2.0L * nu * across), value(c * odd_x),    //
        value(2.0L * nu * across), value(2.0L * (inverse - nu * along_x)), value(c * odd_y),     //
        value(-c * odd_x), value(-c * odd_y), value(2.0L * (1.0L - nu) * inverse);
    return u;
}

}    // namespace stylet::half_space
