// A study's settings as a table, for the terminal and for a page alike.
#pragma once

#include "apps/study/result.h"
#include "apps/stylet/table.h"

#include <string>
#include <vector>

namespace stylet::app {

constexpr const char* front_mark = "◆";        // on the Pareto front
constexpr const char* contended_mark = "†";    // the machine did not run us all the time

struct StudyColumn {
    std::string group;    // columns with the same one stand side by side: "a tick"; empty: none
    std::string name;     // "median"
    Table::Align align;
};

/// Of what a study did not ask for there is no column.
struct StudyTable {
    std::vector<StudyColumn> columns;
    std::vector<std::vector<std::string>> rows;    // a setting each
};

[[nodiscard]] StudyTable study_table(const study::Result& result);

/// What the table's marks mean, a sentence each; of those only that it has.
[[nodiscard]] std::vector<std::string> marks_explained(const study::Result& result);

}    // namespace stylet::app
