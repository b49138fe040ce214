// What a plugin may be given. A parameter is declared once: the declaration reads it, checks it and prints its documentation.
#pragma once

#include <stylet/error.h>
#include <stylet/types.h>

#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace stylet {

enum class Kind : std::uint8_t {
    number,     // a number with `unit`; in SI once read; `unit` "1" means dimensionless
    integer,    // a whole number
    text,       // free text
    choice,     // one word of `choices`
    file,       // a file inside the scene's folder tree; its full path once read
    vector3,    // [x, y, z], each with `unit`
    records     // a list of maps, each with the parameters `fields`
};

enum class Need : std::uint8_t { required, optional };

/// Which way of a parameter buys accuracy with time: above, a larger number (each component of a vector) or a later word of a
/// choice; below, a smaller or an earlier one. Most parameters say what is there, not how finely: neither.
enum class Finer : std::uint8_t { neither, above, below };

/// Which numbers make sense. A bound counts as allowed unless `open`.
struct Range {
    double least = -std::numeric_limits<double>::infinity();      // SI
    double greatest = std::numeric_limits<double>::infinity();    // SI
    bool open_below = false;
    bool open_above = false;
};

inline constexpr Range any{};
inline constexpr Range positive{.least = 0.0, .open_below = true};
inline constexpr Range not_negative{.least = 0.0};

/// One parameter of a plugin. Every pointer is to text that lives as long as the library. No physical constant has a default:
/// an `optional` parameter that is absent switches off what it describes, and `meaning` says what then happens.
struct Parameter {
    const char* name = nullptr;
    Kind kind = Kind::number;
    const char* unit = "";    // UDUNITS-2; empty where the kind has none
    Range range{};
    Need need = Need::required;
    const char* meaning = "";
    const char* choices = "";             // separated by spaces, for Kind::choice
    const Parameter* fields = nullptr;    // for Kind::records
    std::uint32_t field_count = 0;
    Finer finer = Finer::neither;
};

constexpr Parameter number(const char* name, const char* unit, Range range, const char* meaning) {
    return {.name = name, .kind = Kind::number, .unit = unit, .range = range, .meaning = meaning};
}
constexpr Parameter integer(const char* name, Range range, const char* meaning) {
    return {.name = name, .kind = Kind::integer, .range = range, .meaning = meaning};
}
constexpr Parameter text(const char* name, const char* meaning) {
    return {.name = name, .kind = Kind::text, .meaning = meaning};
}
constexpr Parameter choice(const char* name, const char* choices, const char* meaning) {
    return {.name = name, .kind = Kind::choice, .meaning = meaning, .choices = choices};
}
constexpr Parameter file(const char* name, const char* meaning) {
    return {.name = name, .kind = Kind::file, .meaning = meaning};
}
constexpr Parameter vector3(const char* name, const char* unit, const char* meaning) {
    return {.name = name, .kind = Kind::vector3, .unit = unit, .meaning = meaning};
}
template <std::size_t Count>
constexpr Parameter records(const char* name, const Parameter (&fields)[Count], const char* meaning) {
    return {.name = name, .kind = Kind::records, .meaning = meaning, .fields = fields, .field_count = Count};
}
constexpr Parameter optional(Parameter parameter) {
    parameter.need = Need::optional;
    return parameter;
}
constexpr Parameter finer_above(Parameter parameter) {
    parameter.finer = Finer::above;
    return parameter;
}
constexpr Parameter finer_below(Parameter parameter) {
    parameter.finer = Finer::below;
    return parameter;
}

/// Of a plugin that has none.
inline constexpr std::span<const Parameter> no_parameters{};

/// The values of a plugin's parameters, read from the scene, checked against the declarations, in SI.
/// Asking for a value of another kind, or for a required one by a name that was never declared, is a plugin's bug and throws
/// Error.
class Parameters {
public:
    using Records = std::vector<Parameters>;
    using Value = std::variant<double, std::int64_t, std::string, Vector3, Records>;

    void set(const std::string& name, Value value) { values_.insert_or_assign(name, std::move(value)); }
    [[nodiscard]] bool has(std::string_view name) const { return values_.find(name) != values_.end(); }

    [[nodiscard]] double number(std::string_view name) const { return get<double>(name); }    // SI
    [[nodiscard]] std::int64_t integer(std::string_view name) const { return get<std::int64_t>(name); }
    [[nodiscard]] const std::string& text(std::string_view name) const { return get<std::string>(name); }    // text, choice, file
    [[nodiscard]] const Vector3& vector3(std::string_view name) const { return get<Vector3>(name); }         // SI
    [[nodiscard]] const Records& records(std::string_view name) const { return get<Records>(name); }

private:
    template <class T>
    const T& get(std::string_view name) const {
        const auto found = values_.find(name);
        if (found == values_.end()) throw Error(std::string(name), "asked for a parameter that the scene does not give");
        const T* value = std::get_if<T>(&found->second);
        if (value == nullptr) throw Error(std::string(name), "asked for a parameter as another kind than it was declared");
        return *value;
    }

    std::map<std::string, Value, std::less<>> values_;
};

}    // namespace stylet
