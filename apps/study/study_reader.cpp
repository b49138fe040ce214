#include "apps/study/study_reader.h"

#include "apps/study/changes_reader.h"
#include "apps/study/closed_forms.h"
#include "apps/study/study_format.h"
#include "core/run/sample.h"
#include "core/scene/document.h"
#include "core/scene/suggestion.h"
#include "core/scene/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

namespace stylet::study {
namespace {

using core::Reading;
using core::ValueTree;

constexpr const char* kind = "a study";

/// Complains of every key that is neither declared nor one of `more`.
void check_known(const ValueTree& map, const std::string& path, std::span<const Parameter> declared,
                 std::initializer_list<const char*> more, Reading& reading) {
    std::vector<std::string> known = core::names_of(declared);
    known.insert(known.end(), more.begin(), more.end());
    core::refuse_unknown_keys(map, path, known, reading);
}

/// Of several keys of which a map has one: that one, or complains and gives nothing.
std::string only_one_of(const ValueTree& map, const std::string& path, const std::vector<std::string>& keys, Reading& reading) {
    std::vector<std::string> there;
    std::ranges::copy_if(keys, std::back_inserter(there), [&](const std::string& key) { return map.find(key) != nullptr; });
    if (there.size() == 1) return there.front();
    reading.complaints.add(
        map.place, path,
        fmt::format("found {}, wanted one of {}", there.empty() ? "none" : core::list_of(there), core::list_of(keys)));
    return "";
}

/// A map that must be there; complains where it is not.
const ValueTree* map_at(const ValueTree& map, const std::string& path, const char* key, const char* meaning, Reading& reading) {
    const ValueTree* found = map.find(key);
    const std::string inner = core::join(path, key);
    if (found == nullptr) core::miss_key(map, inner, fmt::format("a map ({})", meaning), reading);
    return found != nullptr && core::is_map(*found, inner, meaning, reading) ? found : nullptr;
}

std::filesystem::path file_or_none(const Parameters& parameters, const char* key) {
    if (!parameters.has(key)) return {};
    const std::filesystem::path file = parameters.text(key);
    return file.lexically_proximate(std::filesystem::current_path());    // so that errors are short
}

std::string text_or_none(const Parameters& parameters, const char* key) {
    return parameters.has(key) ? parameters.text(key) : "";
}

int integer_or(const Parameters& parameters, const char* key, int otherwise) {
    return parameters.has(key) ? static_cast<int>(parameters.integer(key)) : otherwise;
}

class StudyReader {
public:
    StudyReader(const ValueTree& root, Reading& reading) : root_(root), reading_(reading) {}

    Study read(const std::filesystem::path& file) {
        study_.file = file;
        read_top();
        read_series();
        read_cases();
        if (const ValueTree* map = map_at(root_, "", "measure", "what is measured", reading_)) read_measure(*map);
        if (const ValueTree* map = map_at(root_, "", "reference", "what it is compared with", reading_)) read_reference(*map);
        if (root_.find("split") != nullptr) read_split();
        if (!reading_.complaints.any()) check_together();
        return std::move(study_);
    }

private:
    void complain(const ValueTree& node, const std::string& path, const std::string& sentence) {
        reading_.complaints.add(node.place, path, sentence);
    }

    void read_top() {
        const Parameters keys = core::read_parameters(root_, "", study_keys, reading_);
        check_known(root_, "", study_keys,
                    {"stylet", set_key, leave_out_key, vary_key, "series", "cases", "measure", "reference", "split"}, reading_);
        study_.title = text_or_none(keys, "title");
        study_.question = text_or_none(keys, "question");
        study_.scene = file_or_none(keys, "scene");
        study_.fit_order = text_or_none(keys, "fit_order");
        study_.repetitions = integer_or(keys, "repetitions", 1);
        study_.threads = integer_or(keys, "threads", 1);
        if (keys.has("time")) study_.timed = timed_of(keys.text("time"));
        study_.changes = read_changes(root_, "", reading_);
    }

    static Timed timed_of(const std::string& word) {
        if (word == "tick") return Timed::tick;
        if (word == "step") return Timed::step;
        if (word == "load") return Timed::load;
        return word == "answer" ? Timed::answer : Timed::nothing;
    }

    void read_series() {
        const std::vector<Vary> of_all = read_varied(root_, "", reading_);
        const ValueTree* list = root_.find("series");
        if (list == nullptr || list->shape != ValueTree::Shape::list || list->items.empty()) {
            complain(list == nullptr ? root_ : *list, "series",
                     fmt::format("found {}, wanted a list of maps (the settings that are compared)",
                                 list == nullptr                                                ? "nothing"
                                 : list->items.empty() && list->shape == ValueTree::Shape::list ? "an empty list"
                                                                                                : list->description()));
            return;
        }
        std::set<std::string> names;
        for (std::size_t i = 0; i < list->items.size(); ++i) {
            const std::string path = core::join("series", i);
            const ValueTree& map = list->items[i];
            if (!core::is_map(map, path, "a series of settings", reading_)) continue;
            study_.series.push_back(read_one_series(map, path, of_all));
            const std::string& name = study_.series.back().name;
            if (!name.empty() && !names.insert(name).second)
                complain(map, core::join(path, "name"),
                         fmt::format("found {} a second time, wanted each once", core::quote(name)));
        }
    }

    Series read_one_series(const ValueTree& map, const std::string& path, const std::vector<Vary>& of_all) {
        const Parameters keys = core::read_parameters(map, path, series_keys, reading_);
        check_known(map, path, series_keys, {set_key, leave_out_key, vary_key}, reading_);
        Series series{.name = text_or_none(keys, "name"),
                      .scene = keys.has("scene") ? file_or_none(keys, "scene") : study_.scene,
                      .changes = read_changes(map, path, reading_),
                      .vary = read_varied(map, path, reading_)};
        series.vary.insert(series.vary.end(), of_all.begin(), of_all.end());
        std::set<std::string> keys_varied;
        for (const Vary& vary : series.vary) {
            if (!keys_varied.insert(vary.key).second)
                complain(map, core::join(path, vary_key),
                         fmt::format("found {} twice, wanted each key once", core::quote(vary.key)));
        }
        if (series.scene.empty() && !map.find("scene") && !root_.find("scene"))
            core::miss_key(map, core::join(path, "scene"), "a scene, here or for all series", reading_);
        return series;
    }

    void read_cases() {
        const ValueTree* map = root_.find("cases");
        if (map == nullptr) {
            study_.cases = {Case{}};
            return;
        }
        if (!core::is_map(*map, "cases", "the situations in which each setting is tried", reading_)) return;
        const Parameters keys = core::read_parameters(*map, "cases", cases_keys, reading_);
        check_known(*map, "cases", cases_keys, {"list", "random"}, reading_);
        if (keys.has("judge")) study_.judge = judge_of(keys.text("judge"));
        const std::string which = only_one_of(*map, "cases", {"list", "random"}, reading_);
        if (which == "list") read_listed_cases(*map->find("list"));
        if (which == "random") read_random_cases(*map->find("random"));
    }

    static Judge judge_of(const std::string& word) {
        if (word == "rms") return Judge::rms;
        if (word == "median") return Judge::median;
        return word == "p95" ? Judge::p95 : Judge::worst;
    }

    void read_listed_cases(const ValueTree& list) {
        if (list.shape != ValueTree::Shape::list || list.items.empty())
            complain(list, "cases.list", fmt::format("found {}, wanted a list of maps", list.description()));
        for (std::size_t i = 0; i < list.items.size(); ++i) {
            const std::string path = core::join("cases.list", i);
            const ValueTree& map = list.items[i];
            if (!core::is_map(map, path, "a case", reading_)) continue;
            const Parameters keys = core::read_parameters(map, path, case_keys, reading_);
            check_known(map, path, case_keys, {set_key, leave_out_key}, reading_);
            Case one{.name = text_or_none(keys, "name"), .changes = read_changes(map, path, reading_)};
            if (keys.has("scene")) one.scene = file_or_none(keys, "scene");
            if (std::ranges::find(study_.cases, one.name, &Case::name) != study_.cases.end())
                complain(map, core::join(path, "name"),
                         fmt::format("found {} a second time, wanted each once", core::quote(one.name)));
            study_.cases.push_back(std::move(one));
        }
    }

    void read_random_cases(const ValueTree& map) {
        const std::string path = "cases.random";
        if (!core::is_map(map, path, "what is drawn", reading_)) return;
        const Parameters keys = core::read_parameters(map, path, random_keys, reading_);
        check_known(map, path, random_keys, {"draw"}, reading_);
        if (map.find("draw") == nullptr) core::miss_key(map, core::join(path, "draw"), "a list of keys that are drawn", reading_);
        const std::vector<Draw> draws = read_draws(map, path, reading_);
        if (!keys.has("count") || !keys.has("seed") || reading_.complaints.any()) return;
        // The generator is the standard's, its distributions are not: a share of 53 bits is the same everywhere.
        std::mt19937_64 random(static_cast<std::uint64_t>(keys.integer("seed")));
        for (std::int64_t i = 0; i < keys.integer("count"); ++i) {
            Case one{.name = fmt::format("case {}", i + 1)};
            for (const Draw& draw : draws) one.changes.push_back(draw.at(static_cast<double>(random() >> 11) * 0x1p-53));
            study_.cases.push_back(std::move(one));
        }
    }

    void read_measure(const ValueTree& map) {
        const Parameters keys = core::read_parameters(map, "measure", measure_keys, reading_);
        check_known(map, "measure", measure_keys, {}, reading_);
        const std::string which = only_one_of(map, "measure", {"curve", "value", "event", "answer"}, reading_);
        const auto want = [&](const char* key) {
            if (map.find(key) == nullptr)
                core::miss_key(map, core::join("measure", key), fmt::format("one beside '{}'", which), reading_);
            return keys.has(key);
        };
        refuse_keys_of_others(map, which);
        if (which == "curve" && want("over")) {
            check_columns(map, {"curve", "over"}, {});
            CurveMeasure curve{.column = text_or_none(keys, "curve"), .over = keys.text("over")};
            read_end(map, "from", curve.over, curve.from);
            read_end(map, "to", curve.over, curve.to);
            if (!(curve.from < curve.to))
                complain(map, "measure", "found a 'from' that is not below 'to', wanted a stretch between them");
            study_.measure = curve;
        } else if (which == "value") {
            check_columns(map, {"value"}, {"peak_hand_force", "largest_deflection"});
            study_.measure = ValueMeasure{text_or_none(keys, "value")};
        } else if (which == "event" && want("column")) {
            check_columns(map, {"column"}, {});
            study_.measure = EventMeasure{text_or_none(keys, "event"), keys.text("column")};
        } else if (which == "answer" && want("depth")) {
            study_.measure = AnswerMeasure{keys.number("depth")};
        }
    }

    /// Complains of keys that go with another kind of measure.
    void refuse_keys_of_others(const ValueTree& map, const std::string& which) {
        const std::map<std::string, std::vector<std::string>> beside{
            {"curve", {"over", "from", "to"}}, {"value", {}}, {"event", {"column"}}, {"answer", {"depth"}}};
        for (const auto& [measure, keys] : beside) {
            for (const std::string& key : keys) {
                const ValueTree* node = map.find(key);
                if (node != nullptr && !which.empty() && measure != which)
                    complain(*node, core::join("measure", key),
                             fmt::format("found it beside '{}', wanted it with '{}' alone", which, measure));
            }
        }
    }

    /// One end of a curve's stretch, in the unit of the column `over`.
    void read_end(const ValueTree& map, const char* key, const std::string& over, double& end) {
        const ValueTree* node = map.find(key);
        const auto column = core::column_named(over);
        if (node == nullptr || column == nullptr) return;
        const core::Quantity quantity = core::read_quantity(node->text, column->unit);
        if (quantity.problem.empty()) {
            end = quantity.value;
        } else {
            complain(*node, core::join("measure", key),
                     fmt::format("found {}, wanted {}", quantity.problem, core::wanted_quantity(column->unit)));
        }
    }

    /// Complains of each of these keys that names no column, and none of these words.
    void check_columns(const ValueTree& map, std::initializer_list<const char*> keys, std::vector<std::string> words) {
        for (const core::Column& column : core::all_columns()) words.emplace_back(column.name);
        for (const char* key : keys) {
            const ValueTree* node = map.find(key);
            if (node == nullptr || node->shape != ValueTree::Shape::scalar) continue;
            if (std::ranges::find(words, node->text) != words.end()) continue;
            complain(*node, core::join("measure", key),
                     fmt::format("found {}, wanted one of {}{}", node->description(), core::list_of(words),
                                 core::suggestion(node->text, words)));
        }
    }

    void read_reference(const ValueTree& map) {
        const Parameters keys = core::read_parameters(map, "reference", reference_keys, reading_);
        check_known(map, "reference", reference_keys, {"run"}, reading_);
        const std::string which = only_one_of(map, "reference", {"closed_form", "curve", "table", "run"}, reading_);
        if (which == "closed_form" && keys.has("closed_form")) {
            study_.reference = ClosedForm{keys.text("closed_form")};
            try {
                (void)closed_form_title(std::get<ClosedForm>(study_.reference));
            } catch (const Error& error) {
                complain(*map.find("closed_form"), "reference.closed_form", error.what());
            }
        } else if (which == "curve") {
            study_.reference = CurveFile{file_or_none(keys, "curve")};
        } else if (which == "table") {
            study_.reference = TableFile{file_or_none(keys, "table")};
        } else if (which == "run") {
            if (const ValueTree* run = map_at(map, "reference", "run", "a run of its own", reading_)) read_reference_run(*run);
        }
    }

    void read_reference_run(const ValueTree& map) {
        const std::string path = "reference.run";
        const Parameters keys = core::read_parameters(map, path, run_keys, reading_);
        check_known(map, path, run_keys, {set_key, leave_out_key}, reading_);
        const std::string of = text_or_none(keys, "of");
        using Of = ReferenceRun::Of;
        study_.reference = ReferenceRun{.of = of == "series"    ? Of::series
                                              : of == "setting" ? Of::setting
                                                                : Of::scene,
                                        .name = text_or_none(keys, "name"),
                                        .changes = read_changes(map, path, reading_)};
        if (of == "scene" && study_.scene.empty() && root_.find("scene") == nullptr)
            complain(*map.find("of"), "reference.run.of", "found 'scene', and the study has none for all series");
    }

    void read_split() {
        const ValueTree& map = *root_.find("split");
        if (!core::is_map(map, "split", "two parts of the error", reading_)) return;
        const Parameters keys = core::read_parameters(map, "split", split_keys, reading_);
        check_known(map, "split", split_keys, {set_key, leave_out_key}, reading_);
        study_.split = Split{.name = text_or_none(keys, "name"),
                             .rest = text_or_none(keys, "rest"),
                             .changes = read_changes(map, "split", reading_)};
    }

    /// What one part asks of another.
    void check_together() {
        const bool answer = std::holds_alternative<AnswerMeasure>(study_.measure);
        const bool curve = std::holds_alternative<CurveMeasure>(study_.measure);
        if ((study_.timed == Timed::answer) != answer && study_.timed != Timed::nothing)
            complain(*root_.find("time"), "time",
                     answer ? "found a measure that is an answer, wanted 'answer' or 'nothing': no scene is run"
                            : "found no answer among what is measured, wanted 'measure: {answer: …}' with it");
        if (study_.timed == Timed::nothing && root_.find("repetitions") != nullptr)
            complain(*root_.find("repetitions"), "repetitions", "found nothing that is timed, wanted no repetitions of it");
        if (std::holds_alternative<CurveFile>(study_.reference) && !curve)
            complain(*root_.find("reference"), "reference.curve",
                     "found a measure that is no curve, wanted 'measure: {curve: …}'");
        if (std::holds_alternative<TableFile>(study_.reference) && curve)
            complain(*root_.find("reference"), "reference.table", "found a measure that is a curve, wanted one of single values");
        const auto varies = [&](const Series& series) {
            return std::ranges::find(series.vary, study_.fit_order, &Vary::key) != series.vary.end();
        };
        if (study_.fit_order.empty() || std::ranges::any_of(study_.series, varies)) return;
        std::vector<std::string> keys;
        for (const Series& series : study_.series) {
            for (const Vary& vary : series.vary) keys.push_back(vary.key);
        }
        complain(*root_.find("fit_order"), "fit_order",
                 fmt::format("found {}, which no series varies{}", core::quote(study_.fit_order),
                             core::suggestion(study_.fit_order, keys)));
    }

    const ValueTree& root_;
    Reading& reading_;
    Study study_{};
};

}    // namespace

Study read_study(const std::filesystem::path& file, const core::PluginFolders& folders) {
    const std::string text = core::document_text(file, kind);
    Reading reading{.files = core::SceneFiles(file), .folders = folders};
    const ValueTree root = core::document_tree(text, file, kind, reading.complaints);
    core::check_version(root, kind, reading);
    if (!core::is_study(root) && root.find("run") != nullptr)
        throw core::SceneErrors({fmt::format("{}: found a scene, wanted a study; stylet run plays it", file.string())});
    Study study = StudyReader(root, reading).read(file);
    reading.complaints.throw_if_any();
    return study;
}

}    // namespace stylet::study
