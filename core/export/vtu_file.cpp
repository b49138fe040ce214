#include "core/export/vtu_file.h"

#include <stylet/error.h>

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <span>
#include <type_traits>

namespace stylet::core {

namespace {

using Bytes = std::span<const unsigned char>;

template <class Number>
Bytes bytes_of(const std::vector<Number>& numbers) {
    return {reinterpret_cast<const unsigned char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

std::string base64(Bytes bytes) {
    constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) { return i + k < bytes.size() ? unsigned{bytes[i + k]} : 0U; };
        const unsigned triple = byte(0) << 16U | byte(1) << 8U | byte(2);
        for (const unsigned shift : {18U, 12U, 6U, 0U}) text.push_back(digits[triple >> shift & 63U]);
    }
    const std::size_t short_of = (3 - bytes.size() % 3) % 3;
    std::fill(text.end() - static_cast<std::ptrdiff_t>(short_of), text.end(), '=');
    return text;
}

/// How VTK packs an array: the number of blocks, their size, that of a last and smaller one, the packed size of each; then the
/// blocks. Ours is always one block.
std::string packed(Bytes bytes) {
    std::vector<unsigned char> block(compressBound(bytes.size()));
    uLongf size = block.size();
    const int outcome = compress2(block.data(), &size, bytes.data(), bytes.size(), Z_BEST_SPEED);
    if (outcome != Z_OK) throw std::bad_alloc();    // the one thing that it can lack here
    block.resize(size);
    return base64(bytes_of(std::vector<std::uint64_t>{1, bytes.size(), 0, size})) + base64(bytes_of(block));
}

template <class Number>
constexpr const char* type_name() {
    if constexpr (std::is_same_v<Number, float>) return "Float32";
    if constexpr (std::is_same_v<Number, double>) return "Float64";
    if constexpr (std::is_same_v<Number, std::int32_t>) return "Int32";
    if constexpr (std::is_same_v<Number, std::uint8_t>) return "UInt8";
}

/// The text of one file, element by element.
class VtuText {
public:
    explicit VtuText(const UnstructuredGrid& grid) {
        constexpr const char* order = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
        add("<?xml version=\"1.0\"?>\n<!-- {} -->\n", grid.about);
        add("<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\" "
            "compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n",
            order);
        field_data(grid.field_data);
        const bool drawn = grid.finite();
        add("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", drawn ? grid.points.size() : 0, drawn ? grid.cells() : 0);
        data("PointData", grid.point_data, drawn);
        data("CellData", grid.cell_data, drawn);
        points(drawn ? grid.points : std::vector<Vector3>{});
        cells(grid.cell_type, drawn ? grid.connectivity : std::vector<int>{});
        add("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    }

    [[nodiscard]] const std::string& text() const { return text_; }

private:
    template <class... Parts>
    void add(fmt::format_string<Parts...> format, Parts&&... parts) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Parts>(parts)...);
    }

    template <class Number>
    void array(const std::string& name, int components, const std::vector<Number>& values) {
        // Of one component it isn't said: readers other than VTK's would make a table of one column of it.
        const std::string shape = components == 1 ? "" : fmt::format("NumberOfComponents=\"{}\" ", components);
        add("<DataArray type=\"{}\" Name=\"{}\" {}format=\"binary\">{}</DataArray>\n", type_name<Number>(), xml_attribute(name),
            shape, packed(bytes_of(values)));
    }

    void field_data(const std::vector<FieldValue>& fields) {
        add("<FieldData>\n");
        for (const FieldValue& field : fields) {
            if (!std::isfinite(field.value)) continue;
            add("<DataArray type=\"Float64\" Name=\"{}\" NumberOfTuples=\"1\" format=\"binary\">{}</DataArray>\n",
                xml_attribute(field.name), packed(bytes_of(std::vector<double>{field.value})));
        }
        add("</FieldData>\n");
    }

    void data(const char* element, const std::vector<DataArray>& arrays, bool drawn) {
        add("<{}>\n", element);
        for (const DataArray& given : arrays) {
            std::vector<float> values;
            if (drawn) values.assign(given.values.begin(), given.values.end());
            array(given.name, given.components, values);
        }
        add("</{}>\n", element);
    }

    void points(const std::vector<Vector3>& points) {
        std::vector<float> coordinates;
        coordinates.reserve(3 * points.size());
        for (const Vector3& point : points) {
            for (const double coordinate : point) coordinates.push_back(static_cast<float>(coordinate));
        }
        add("<Points>\n");
        array("points", 3, coordinates);
        add("</Points>\n");
    }

    void cells(CellType type, const std::vector<int>& connectivity) {
        const int each = points_of(type);
        std::vector<std::int32_t> ends(connectivity.size() / each);
        for (std::size_t i = 0; i < ends.size(); ++i) ends[i] = static_cast<std::int32_t>(i + 1) * each;
        add("<Cells>\n");
        array("connectivity", 1, connectivity);
        array("offsets", 1, ends);
        array("types", 1, std::vector<std::uint8_t>(ends.size(), static_cast<std::uint8_t>(type)));
        add("</Cells>\n");
    }

    std::string text_;
};

}    // namespace

bool UnstructuredGrid::finite() const {
    const auto drawable = [](double number) { return std::abs(number) <= std::numeric_limits<float>::max(); };
    const auto all_drawable = [&](const auto& numbers) { return std::all_of(numbers.begin(), numbers.end(), drawable); };
    const auto sound = [&](const DataArray& array) { return all_drawable(array.values); };
    return std::all_of(points.begin(), points.end(), all_drawable) && std::all_of(point_data.begin(), point_data.end(), sound) &&
           std::all_of(cell_data.begin(), cell_data.end(), sound);
}

void write_vtu(const std::filesystem::path& file, const UnstructuredGrid& grid) {
    const VtuText vtu(grid);
    errno = 0;
    std::ofstream out(file, std::ios::binary | std::ios::trunc);
    out << vtu.text();
    out.close();
    if (!out) throw Error(fmt::format("{}: cannot be written: {}", file.string(), std::strerror(errno)));
}

std::string xml_attribute(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        switch (c) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            default:
                safe.push_back(static_cast<unsigned char>(c) < ' ' ? '?' : c);
        }
    }
    return safe;
}

}    // namespace stylet::core
