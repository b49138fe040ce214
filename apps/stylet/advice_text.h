// What was advised on a scene, for a terminal and for scripts.
#pragma once

#include "apps/study/advice.h"

#include <string>

namespace stylet::app {

[[nodiscard]] std::string advice_text(const study::Advice& advice);

[[nodiscard]] std::string advice_json(const study::Advice& advice);

/// "stylet run scene.yaml --set needle.type=rod --set 'run.rate=2 kHz'", as a shell takes it.
[[nodiscard]] std::string run_command(const std::filesystem::path& scene, const std::vector<core::Override>& changes);

}    // namespace stylet::app
