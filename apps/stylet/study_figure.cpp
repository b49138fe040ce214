#include "apps/stylet/study_figure.h"

#include <algorithm>
#include <cmath>

namespace stylet::app {

Figure figure_of(const study::Result& result) {
    Figure figure;
    figure.title = result.title;
    figure.x_label = "Time (µs)";
    figure.y_label = "Error (%)";
    for (const study::SettingResult& setting : result.settings) {
        if (!setting.timing || !std::isfinite(setting.error.judged)) continue;
        const Point at{setting.timing->median, 100.0 * setting.error.judged};
        if (figure.curves.empty() || figure.curves.back().name != setting.series)
            figure.curves.push_back({.name = setting.series, .points = {}, .marks = {}});
        figure.curves.back().points.push_back(at);
        figure.curves.back().marks.push_back({at, setting.label});
    }
    fit_axes(figure);
    return figure;
}

PictureFiles draw_study(const study::Result& result, const std::filesystem::path& stem) {
    return draw(figure_of(result), stem);
}

}    // namespace stylet::app
