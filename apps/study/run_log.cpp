#include "apps/study/run_log.h"

#include <nlohmann/json.hpp>

#include <cerrno>
#include <limits>
#include <system_error>

namespace stylet::study {
namespace {

using Json = nlohmann::json;

Json to_json(const Timing& timing) {
    return {{"median", timing.median}, {"p99", timing.p99},       {"worst", timing.worst},
            {"mean", timing.mean},     {"waited", timing.waited}, {"contended", timing.contended}};
}

Timing to_timing(const Json& json) {
    return {.median = json.at("median"),
            .p99 = json.at("p99"),
            .worst = json.at("worst"),
            .mean = json.at("mean"),
            .waited = json.at("waited"),
            .contended = json.at("contended")};
}

/// JSON knows no infinity: null stands for what is not finite.
std::vector<double> to_numbers(const Json& json) {
    std::vector<double> numbers;
    for (const Json& value : json)
        numbers.push_back(value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>());
    return numbers;
}

Outcome to_outcome(const Json& json) {
    Outcome outcome{.x = to_numbers(json.at("x")),
                    .y = to_numbers(json.at("y")),
                    .missing = json.at("missing"),
                    .remarks = json.at("remarks")};
    if (json.contains("timing")) outcome.timing = to_timing(json.at("timing"));
    return outcome;
}

[[noreturn]] void refuse(const std::filesystem::path& file) {
    throw std::system_error(errno, std::generic_category(), file.string());
}

}    // namespace

RunLog::RunLog(const std::filesystem::path& file, bool forget) : file_(file), lock_(file) {
    if (file.empty()) return;
    const bool whole = forget || read_earlier();
    stream_.open(file, forget ? std::ios::trunc : std::ios::app);
    if (!whole) stream_ << '\n';
    if (!stream_) refuse(file);
}

bool RunLog::read_earlier() {
    bool whole = true;
    std::ifstream earlier(file_);
    for (std::string line; std::getline(earlier, line);) {
        whole = !earlier.eof();
        const Json json = Json::parse(line, nullptr, false);
        try {
            if (json.is_object()) known_.insert_or_assign(json.at("key").get<std::string>(), to_outcome(json));
        } catch (const Json::exception&) {    // another version's line: measured again
        }
    }
    return whole;
}

const Outcome* RunLog::find(const std::string& key) const {
    const auto found = known_.find(key);
    const bool timed_in_vain = found != known_.end() && found->second.timing && found->second.timing->contended;
    return found == known_.end() || timed_in_vain ? nullptr : &found->second;
}

void RunLog::add(const std::string& key, const std::string& name, const Outcome& outcome) {
    if (file_.empty()) return;
    Json json{{"key", key},
              {"name", name},
              {"x", outcome.x},
              {"y", outcome.y},
              {"missing", outcome.missing},
              {"remarks", outcome.remarks}};
    if (outcome.timing) json["timing"] = to_json(*outcome.timing);
    const std::string line = json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
    const std::lock_guard lock(mutex_);
    stream_ << line << std::flush;
    if (!stream_) refuse(file_);
}

}    // namespace stylet::study
