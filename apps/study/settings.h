// The settings that a study's series stand for.
#pragma once

#include "apps/study/study.h"

namespace stylet::study {

struct Setting {
    std::string series;
    std::string label;    // of its varied values; empty where there are none
    std::filesystem::path scene;
    std::vector<core::Override> of_series;    // the study's changes and the series'
    std::vector<core::Override> changes;      // those and the varied values
    std::optional<double> fitted{};           // the number of the key that orders are fitted in, in its first value's unit

    [[nodiscard]] std::string name() const { return label.empty() ? series : series + ", " + label; }
};

/// Every combination of each series' varied values, the last key's values first. Throws core::SceneErrors where an order is to be
/// fitted in what is no number.
[[nodiscard]] std::vector<Setting> settings_of(const Study& study);

/// A value as YAML has it, for people: "15×15×10" of ["15", "15", "10"].
[[nodiscard]] std::string shown_value(const std::string& yaml);

}    // namespace stylet::study
