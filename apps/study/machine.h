#pragma once

#include "apps/study/result.h"

#include <filesystem>

namespace stylet::study {

/// The machine this runs on, as a reader of times wants to know it: the processor's name, how many of them this process may
/// use, the system's and its kernel's names, and the build. What the system does not tell reads "unknown"; never its host name.
[[nodiscard]] Machine this_machine();

/// The value after the first line "`key` : value" of a file like /proc/cpuinfo, or after `key`=value as os-release has it,
/// without quotes; empty where there is none.
[[nodiscard]] std::string value_in(const std::filesystem::path& file, const std::string& key);

}    // namespace stylet::study
