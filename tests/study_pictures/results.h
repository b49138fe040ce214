// Results of studies, made by hand.
#pragma once

#include "apps/study/result.h"

namespace stylet::study_pictures {

/// Three settings that were each run once: what most studies begin as.
[[nodiscard]] study::Result three_settings();

/// Five series, twenty-six settings, some of them side by side, one that never punctured and two on a busy machine.
[[nodiscard]] study::Result many_settings();

/// Forty settings within two decades: as many as a picture is to name.
[[nodiscard]] study::Result crowd();

/// Of many cases, with each error split in two parts.
[[nodiscard]] study::Result split_errors();

/// One setting that failed, one that is the reference itself, one that is far off; the reference is a timed run.
[[nodiscard]] study::Result odd_settings();

/// Models that answer a formula within microseconds.
[[nodiscard]] study::Result fast_answers();

/// Errors alone.
[[nodiscard]] study::Result nothing_timed();

}    // namespace stylet::study_pictures
