#include "apps/study/machine.h"

#include <fmt/format.h>

#include <sched.h>
#include <sys/utsname.h>

#include <algorithm>
#include <fstream>
#include <initializer_list>
#include <string_view>
#include <thread>

namespace stylet::study {
namespace {

std::string trimmed(std::string_view text) {
    constexpr std::string_view around = " \t\r\"'";
    const std::size_t begin = text.find_first_not_of(around);
    if (begin == std::string_view::npos) return {};
    return std::string(text.substr(begin, text.find_last_not_of(around) - begin + 1));
}

std::string processor() {
    // An Arm kernel names its board or its parts, if anything.
    for (const char* key : {"model name", "Model", "Hardware", "cpu", "uarch"}) {
        if (std::string name = value_in("/proc/cpuinfo", key); !name.empty()) return name;
    }
    return "unknown";
}

/// Those that this process may run on: a container or a taskset has fewer than the machine.
int processors() {
    cpu_set_t allowed;
    if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) return CPU_COUNT(&allowed);
    return static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

std::string system_name() {
    utsname kernel{};
    const bool named = uname(&kernel) == 0;
    const std::string distribution = value_in("/etc/os-release", "PRETTY_NAME");
    const std::string release = kernel.release;    // of which the first two numbers: the rest is a distribution's own
    const std::string under = named ? fmt::format("{} {} {}", kernel.sysname,
                                                  release.substr(0, release.find('.', release.find('.') + 1)), kernel.machine)
                                    : "unknown";
    return distribution.empty() ? under : fmt::format("{}, {}", distribution, under);
}

std::string build() {
#if defined(__clang__)
    const std::string compiler = fmt::format("clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#else
    const std::string compiler = fmt::format("g++ {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
    constexpr std::string_view kind = STYLET_BUILD;
    return fmt::format("stylet {}, {}, {}", STYLET_VERSION, compiler, kind.empty() ? "no build type" : kind);
}

}    // namespace

std::string value_in(const std::filesystem::path& file, const std::string& key) {
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        const std::size_t sign = line.find_first_of(":=");
        if (sign != std::string::npos && trimmed(line.substr(0, sign)) == key) return trimmed(line.substr(sign + 1));
    }
    return {};
}

Machine this_machine() {
    return {.processor = processor(), .processors = processors(), .system = system_name(), .build = build()};
}

}    // namespace stylet::study
