#include "core/scene/parameter_reader.h"

#include "core/scene/suggestion.h"
#include "core/scene/units.h"
#include "core/scene/wanted.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

namespace stylet::core {
namespace {

using Shape = ValueTree::Shape;
using Value = std::optional<Parameters::Value>;

/// One value on its way from the tree to the parameters: what it is called, where it stands, what it means.
class ValueReader {
public:
    ValueReader(const ValueTree& node, std::string path, const Parameter& declared, Reading& reading)
        : node_(node), path_(std::move(path)), declared_(declared), reading_(reading) {}

    Value read() {
        switch (declared_.kind) {
            case Kind::number:
                return number();
            case Kind::integer:
                return integer();
            case Kind::text:
                return text();
            case Kind::choice:
                return choice();
            case Kind::file:
                return file();
            case Kind::vector3:
                return vector3();
            case Kind::records:
                break;
        }
        return records();
    }

private:
    std::nullopt_t complain(const std::string& found, const std::string& what_was_wanted, const std::string& suggested = "") {
        std::string sentence = fmt::format("found {}, wanted {}", found, what_was_wanted);
        if (*declared_.meaning != '\0') sentence += fmt::format(" ({})", declared_.meaning);
        reading_.complaints.add(node_.place, path_, sentence + suggested);
        return std::nullopt;
    }
    std::nullopt_t complain_of_shape() { return complain(node_.description(), wanted_by(declared_)); }

    [[nodiscard]] bool in_range(double value) const {
        const Range& range = declared_.range;
        const bool above = range.open_below ? value > range.least : value >= range.least;
        const bool below = range.open_above ? value < range.greatest : value <= range.greatest;
        return above && below;
    }

    Value number() {
        if (node_.shape != Shape::scalar) return complain_of_shape();
        Quantity quantity;
        try {
            quantity = read_quantity(node_.text, declared_.unit);
        } catch (const Error& error) {    // of the program's installation or the plugin's declaration, not the scene's
            reading_.complaints.add(node_.place, path_, error.what());
            return std::nullopt;
        }
        if (!quantity.problem.empty()) return complain(quantity.problem, wanted_by(declared_));
        if (!in_range(quantity.value)) return complain(node_.description(), bounds_of(declared_));
        return quantity.value;
    }

    Value integer() {
        if (node_.shape != Shape::scalar) return complain_of_shape();
        std::int64_t value = 0;
        const char* const end = node_.text.data() + node_.text.size();
        const auto [stop, error] = std::from_chars(node_.text.data(), end, value);
        if (error != std::errc{} || stop != end) return complain_of_shape();
        if (!in_range(static_cast<double>(value))) return complain(node_.description(), bounds_of(declared_));
        return value;
    }

    Value text() {
        if (node_.shape != Shape::scalar) return complain_of_shape();
        return node_.text;
    }

    Value choice() {
        if (node_.shape != Shape::scalar) return complain_of_shape();
        const std::vector<std::string> words = choices_of(declared_);
        if (std::ranges::find(words, node_.text) != words.end()) return node_.text;
        return complain(node_.description(), wanted_by(declared_), suggestion(node_.text, words));
    }

    Value file() {
        if (node_.shape != Shape::scalar || node_.text.empty()) return complain_of_shape();
        const SceneFiles::Found found = reading_.files.find(node_.text);
        if (found.problem.empty()) return found.file.string();
        return complain(found.problem, wanted_by(declared_));
    }

    Value vector3() {
        if (node_.shape != Shape::list) return complain_of_shape();
        if (node_.items.size() != 3) return complain(fmt::format("a list of {}", node_.items.size()), wanted_by(declared_));
        Parameter component = declared_;
        component.kind = Kind::number;
        Vector3 vector;
        bool good = true;
        for (std::size_t i = 0; i < 3; ++i) {
            const Value value = ValueReader(node_.items[i], join(path_, i), component, reading_).read();
            good = good && value.has_value();
            if (value) vector[static_cast<Eigen::Index>(i)] = std::get<double>(*value);
        }
        return good ? Value(vector) : std::nullopt;
    }

    Value records() {
        if (node_.shape != Shape::list) return complain_of_shape();
        if (node_.items.empty() && declared_.need == Need::required) return complain("an empty list", "at least one");
        const std::span fields(declared_.fields, declared_.field_count);
        Parameters::Records records;
        for (std::size_t i = 0; i < node_.items.size(); ++i) {
            const ValueTree& item = node_.items[i];
            const std::string item_path = join(path_, i);
            reading_.places.insert_or_assign(item_path, item.place);
            records.emplace_back();
            if (!is_map(item, item_path, declared_.meaning, reading_)) continue;
            records.back() = read_parameters(item, item_path, fields, reading_);
            refuse_unknown_keys(item, item_path, names_of(fields), reading_);
        }
        return records;
    }

    const ValueTree& node_;
    std::string path_;
    const Parameter& declared_;
    Reading& reading_;
};

}    // namespace

bool is_map(const ValueTree& node, const std::string& path, const std::string& meaning, Reading& reading) {
    if (node.shape == Shape::map) return true;
    reading.complaints.add(node.place, path, fmt::format("found {}, wanted a map ({})", node.description(), meaning));
    return false;
}

Parameters read_parameters(const ValueTree& map, const std::string& path, std::span<const Parameter> declared, Reading& reading) {
    Parameters parameters;
    for (const Parameter& parameter : declared) {
        const std::string parameter_path = join(path, parameter.name);
        if (const ValueTree* node = map.find(parameter.name)) {
            reading.places.insert_or_assign(parameter_path, node->place);
            if (Value value = ValueReader(*node, parameter_path, parameter, reading).read())
                parameters.set(parameter.name, *value);
        } else if (parameter.need == Need::required) {
            miss_key(map, parameter_path, fmt::format("{} ({})", wanted_by(parameter), parameter.meaning), reading);
        }
    }
    return parameters;
}

void refuse_unknown_key(const ValueTree::Entry& entry, const std::string& path, const std::string& wanted,
                        const std::vector<std::string>& candidates, Reading& reading) {
    reading.complaints.add(entry.place, join(path, entry.key),
                           "found an unknown key, wanted " + wanted + suggestion(entry.key, candidates));
}

void refuse_unknown_keys(const ValueTree& map, const std::string& path, const std::vector<std::string>& known, Reading& reading) {
    const std::string wanted = known.empty() ? "none" : "one of " + list_of(known);
    for (const ValueTree::Entry& entry : map.entries) {
        if (std::ranges::find(known, entry.key) == known.end()) refuse_unknown_key(entry, path, wanted, known, reading);
    }
}

void miss_key(const ValueTree& map, const std::string& path, const std::string& wanted, Reading& reading) {
    reading.complaints.add(map.place, path, "found nothing, wanted " + wanted);
}

std::vector<std::string> names_of(std::span<const Parameter> declared) {
    std::vector<std::string> names;
    for (const Parameter& parameter : declared) names.emplace_back(parameter.name);
    return names;
}

double number_or_nan(const Parameters& parameters, std::string_view name) {
    return parameters.has(name) ? parameters.number(name) : std::numeric_limits<double>::quiet_NaN();
}

}    // namespace stylet::core
