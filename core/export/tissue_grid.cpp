#include "core/export/tissue_grid.h"

#include "core/export/body_grids.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace stylet::core {

namespace {

constexpr int cells_each_side = 12;            // of the needle's line, along x and y
constexpr int cells_down = 12;                 // without the borders of layers
constexpr double finest_down = 1.0 / 100.0;    // of the depth
constexpr double same_place = 1e-6;            // of the depth: a border this close to a line needs none of its own
constexpr double any = std::numeric_limits<double>::infinity();    // [m] no need for short cells

/// The point of the surface that the needle heads for; where it heads for none, the one above or below its tip. Nothing where
/// there is no needle.
std::optional<Vector3> entry_point(const Scene& scene, const Simulation& simulation) {
    if (!scene.needle_setup) return std::nullopt;
    const double length = scene.needle_setup->length;
    const Vector3 extent = scene.tissue_setup->extent, tip = simulation.needle().position(length);
    const Vector3 ahead = (tip.norm() + extent.norm()) * simulation.needle().tangent(length);    // far enough to get there
    const double fraction = simulation.tissue().entry(tip, tip + ahead);
    const Vector3 entry = tip + std::max(0.0, fraction) * ahead;
    return entry.cwiseMax(-0.5 * extent).cwiseMin(0.5 * extent);
}

/// The grid's places [m] along x or y, ascending: from −width/2 to width/2, with shortest cells of `finest` beside `centre`.
std::vector<double> across(double width, double centre, double finest) {
    std::vector<double> places;
    for (const double distance : graded(centre + 0.5 * width, cells_each_side, finest)) places.push_back(centre - distance);
    std::reverse(places.begin(), places.end());
    places.push_back(centre);
    for (const double distance : graded(0.5 * width - centre, cells_each_side, finest)) places.push_back(centre + distance);
    return places;
}

/// The same along z, from the bottom to the surface, with a place at each border of two layers.
std::vector<double> down(const TissueSetup& tissue, double finest) {
    const double depth = tissue.extent.z();
    std::vector<double> places{0.0};
    for (const double distance : graded(depth, cells_down, finest)) places.push_back(-distance);
    double border = 0.0;
    for (const Layer& layer : tissue.layers) {
        border -= layer.thickness;
        const auto here = [&](double place) { return std::abs(place - border) < same_place * depth; };
        if (border > -depth && std::none_of(places.begin(), places.end(), here)) places.push_back(border);
    }
    std::sort(places.begin(), places.end());
    return places;
}

/// The cells between the places, in the order in which the points run: x first, z last.
UnstructuredGrid block(const std::array<std::vector<double>, 3>& places) {
    UnstructuredGrid grid{.about = "The tissue where it is, in m; points minus displacement is where it was undeformed",
                          .cell_type = CellType::hexahedron};
    const auto& [xs, ys, zs] = places;
    for (const double z : zs) {
        for (const double y : ys) {
            for (const double x : xs) grid.points.emplace_back(x, y, z);
        }
    }
    const int row = static_cast<int>(xs.size()), sheet = row * static_cast<int>(ys.size());
    for (int k = 0; k + 1 < static_cast<int>(zs.size()); ++k) {
        for (int j = 0; j + 1 < static_cast<int>(ys.size()); ++j) {
            for (int i = 0; i + 1 < row; ++i) {
                const int at = i + j * row + k * sheet;
                for (const int corner : {at, at + 1, at + 1 + row, at + row}) grid.connectivity.push_back(corner);
                for (const int corner : {at, at + 1, at + 1 + row, at + row}) grid.connectivity.push_back(corner + sheet);
            }
        }
    }
    return grid;
}

Vector3 middle_of(const UnstructuredGrid& grid, std::size_t cell) {
    const int each = points_of(grid.cell_type);
    Vector3 sum = Vector3::Zero();
    for (int i = 0; i < each; ++i) sum += grid.points[grid.connectivity[cell * each + i]];
    return sum / each;
}

}    // namespace

std::vector<double> graded(double length, int count, double first) {
    if (!(length > 0.0)) return {};
    const auto reach = [&](double growth) {    // of all pieces
        double sum = 0.0;
        for (int i = 0; i < count; ++i) sum = sum * growth + first;
        return sum;
    };
    double low = 1.0, high = std::max(1.0, length / first);
    for (int bisection = 0; bisection < 100; ++bisection) {
        const double growth = std::sqrt(low * high);
        (reach(growth) < length ? low : high) = growth;
    }
    const double equal = length / count;
    std::vector<double> distances;
    double piece = std::min(first, equal), distance = 0.0;
    for (int i = 0; i < count; ++i, piece *= low) distances.push_back(distance += piece);
    distances.back() = length;
    return distances;
}

TissueGrid::TissueGrid(const Scene& scene, const Simulation& simulation) {
    const TissueSetup& tissue = *scene.tissue_setup;
    const auto entry = entry_point(scene, simulation);
    const Vector3 centre = entry.value_or(Vector3::Zero());
    const double finest = entry ? scene.needle_setup->radius : any;
    undeformed_ = block({across(tissue.extent.x(), centre.x(), finest), across(tissue.extent.y(), centre.y(), finest),
                         down(tissue, entry ? finest_down * tissue.extent.z() : any)});
    DataArray layer{"layer", 1, {}};
    for (std::size_t i = 0; i < undeformed_.cells(); ++i) {
        layer.values.push_back(simulation.tissue().locate(middle_of(undeformed_, i)).layer);
    }
    undeformed_.cell_data = {std::move(layer)};
    for (std::size_t i = 0; i < tissue.layers.size(); ++i) {
        undeformed_.field_data.push_back(
            {fmt::format("layer {}: {}", i, tissue.layers[i].name), tissue.layers[i].youngs_modulus});
    }
}

UnstructuredGrid TissueGrid::at_present(const Simulation& simulation) const {
    UnstructuredGrid grid = undeformed_;
    DataArray displacement{"displacement", 3, {}};
    displacement.values.reserve(3 * grid.points.size());
    for (Vector3& point : grid.points) {
        const Vector3 moved = simulation.tissue().displacement(point);
        displacement.values.insert(displacement.values.end(), moved.begin(), moved.end());
        point += moved;
    }
    grid.point_data = {std::move(displacement)};
    const std::vector<FieldValue> recorded = recorded_of(Column::Of::tissue, simulation.sample());
    grid.field_data.insert(grid.field_data.end(), recorded.begin(), recorded.end());
    return grid;
}

}    // namespace stylet::core
