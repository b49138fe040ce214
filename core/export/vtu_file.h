#pragma once

#include "core/export/unstructured_grid.h"

#include <filesystem>

namespace stylet::core {

/// Writes a grid as a VTU file, VTK's XML format of unstructured grids: numbers in base64, compressed by zlib, points and arrays
/// in single precision, field data in double. What isn't finite can't be drawn: a field value that isn't is left out, and a grid
/// that isn't is written without points and cells, so that the file opens whatever happened. Throws Error where it cannot be
/// written.
void write_vtu(const std::filesystem::path& file, const UnstructuredGrid& grid);

/// `text` as the value of an XML attribute. Bytes that XML forbids are replaced by '?'.
[[nodiscard]] std::string xml_attribute(const std::string& text);

}    // namespace stylet::core
