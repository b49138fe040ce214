// What a picture is made of, in the words of VTK: points, cells between them, and named numbers of each.
#pragma once

#include <stylet/types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace stylet::core {

/// The numbers are VTK's own.
enum class CellType : std::uint8_t { vertex = 1, line = 3, tetrahedron = 10, hexahedron = 12 };

[[nodiscard]] constexpr int points_of(CellType type) {
    switch (type) {
        case CellType::vertex:
            return 1;
        case CellType::line:
            return 2;
        case CellType::tetrahedron:
            return 4;
        case CellType::hexahedron:
            return 8;
    }
    return 0;
}

/// `components` numbers for each point, or for each cell.
struct DataArray {
    std::string name;
    int components;
    std::vector<double> values;
};

/// One number of the whole grid.
struct FieldValue {
    std::string name;
    double value;
};

struct UnstructuredGrid {
    std::string about{};    // for whoever opens the file in an editor
    CellType cell_type = CellType::vertex;
    std::vector<Vector3> points{};      // [m] world
    std::vector<int> connectivity{};    // the points of one cell after the other, each cell's in VTK's order
    std::vector<DataArray> point_data{};
    std::vector<DataArray> cell_data{};
    std::vector<FieldValue> field_data{};

    [[nodiscard]] std::size_t cells() const { return connectivity.size() / points_of(cell_type); }

    /// Whether every position and every number of a point or a cell can be drawn. A single-precision number must hold it.
    [[nodiscard]] bool finite() const;
};

}    // namespace stylet::core
