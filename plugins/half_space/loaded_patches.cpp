#include "loaded_patches.h"

#include <cmath>
#include <sstream>

namespace stylet::half_space {

namespace {

// [m] In the sums over the corners of two smaller patches at the far ends of a block rounding would be all there is.
constexpr double shortest_side = 1e-5;
constexpr std::size_t most_patches = 1000;    // of their dense compliance, 72 MB
// [m] A patch that reaches so little beyond the block is a matter of rounding.
constexpr double edge_tolerance = 1e-9;

template <class... Parts>
std::string sentence(const Parts&... parts) {
    std::ostringstream text;
    (text << ... << parts);
    return text.str();
}

}    // namespace

LoadedPatches::LoadedPatches(const TissueSetup& tissue, double half_blur)
    : tissue_(tissue),
      poisson_ratio_(tissue.layers.front().poisson_ratio),
      half_blur_(half_blur),
      weight_(1.0 / std::sqrt(tissue.layers.front().youngs_modulus)) {}

Rectangle LoadedPatches::rectangle_of(const Patch& patch) const {
    const Vector3 &centre = patch.centre, &size = patch.size, &extent = tissue_.extent;
    if (size.z() != 0.0)
        throw Error("size", sentence("found a height of ", size.z(), " m, wanted 0 m: half_space bears loads on its top alone"));
    if (centre.z() != 0.0)
        throw Error("centre", sentence("found z = ", centre.z(), " m, wanted 0 m: half_space bears loads on its top alone"));
    if (!(std::min(size.x(), size.y()) >= shortest_side)) {
        throw Error("size", sentence("found ", size.x(), " m by ", size.y(), " m, wanted a rectangle with sides of at least ",
                                     shortest_side, " m"));
    }
    const Eigen::Array2d reach = centre.head<2>().array().abs() + 0.5 * size.head<2>().array();
    if ((reach > 0.5 * extent.head<2>().array() + edge_tolerance).any()) {
        throw Error("centre", sentence("found a patch that reaches beyond the block's top of ", extent.x(), " m by ", extent.y(),
                                       " m around the origin, wanted it within"));
    }
    return {.x = centre.x(), .y = centre.y(), .half_x = 0.5 * size.x(), .half_y = 0.5 * size.y()};
}

void LoadedPatches::place(std::span<const Patch> patches) {
    if (patches.size() > most_patches)
        throw Error("effects", sentence("found ", patches.size(), " loaded patches, half_space bears at most ", most_patches));
    rectangles_.clear();
    for (const Patch& patch : patches) rectangles_.push_back(rectangle_of(patch));
    own_.resize(3 * count(), 3 * count());
    of_contacts_.setZero(3 * max_contacts, 3 * count());
    for (int i = 0; i < count(); ++i) {
        for (int j = 0; j <= i; ++j) {
            const Matrix3 moves = weight_ * weight_ * mean_response(poisson_ratio_, rectangles_[j], rectangles_[i]);
            own_.block<3, 3>(3 * i, 3 * j) = moves;
            own_.block<3, 3>(3 * j, 3 * i) = moves.transpose();
        }
    }
}

void LoadedPatches::meet(int contact, std::span<const Vector3> samples, double weight) {
    for (int j = 0; j < count(); ++j) {
        Matrix3 sum = Matrix3::Zero();
        for (const Vector3& sample : samples) sum += response(poisson_ratio_, rectangles_[j], sample, half_blur_);
        of_contacts_.block<3, 3>(3 * contact, 3 * j) = weight * weight_ * sum;
    }
}

Vector3 LoadedPatches::displacement(const Vector3& x, const VectorX& forces) const {
    Vector3 sum = Vector3::Zero();
    for (int j = 0; j < count(); ++j) {
        sum += response(poisson_ratio_, rectangles_[j], x, half_blur_) * forces.segment<3>(3 * j);
    }
    return weight_ * sum;
}

}    // namespace stylet::half_space
