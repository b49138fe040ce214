// Known answers from files: a curve, or a value for each case.
#pragma once

#include "apps/study/outcome.h"
#include "apps/study/study.h"

#include <filesystem>
#include <map>
#include <string>

namespace stylet::study {

/// The curve of the measure's two columns, in SI, from a recording or from any CSV whose header names them, each with a unit of
/// its dimension: `travel [mm],hand_force [N]`. Its other columns, empty lines and lines that begin with # are passed over.
/// Throws Error (file:line, what was found, what was wanted) where the file is not such a table or has no row.
[[nodiscard]] Outcome curve_file(const std::filesystem::path& file, const CurveMeasure& measure);

/// What a table must say in its header.
struct TableForm {
    std::string unit;           // SI; the header's may be any of its dimension
    std::string of{};           // scene; empty: any word
    std::string quantity{};     // load; empty: any word
    bool above_zero = false;    // every value
};

/// The value of each case, in SI, from a CSV whose header is like `case,load [N]`. Empty lines and lines that begin with # are
/// passed over. Throws Error (file:line, what was found, what was wanted) where the file is not such a table.
[[nodiscard]] std::map<std::string, double> table_file(const std::filesystem::path& file, const TableForm& form);

/// The SI unit of what is measured (of a curve: of its y), as recordings name it.
[[nodiscard]] std::string unit_of(const Measure& measure);

}    // namespace stylet::study
