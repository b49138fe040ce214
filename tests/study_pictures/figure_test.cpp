#include "apps/stylet/page.h"
#include "apps/stylet/study_figure.h"
#include "tests/study_pictures/results.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace stylet::study_pictures {
namespace {

using app::Beyond;
using app::Curve;
using app::Figure;
using app::Mark;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<study::Result> all_results() {
    return {three_settings(), many_settings(), crowd(), split_errors(), odd_settings(), fast_answers(), nothing_timed()};
}

const Mark* mark_of(const Figure& figure, const std::string& text) {
    for (const Curve& curve : figure.curves) {
        for (const Mark& mark : curve.marks) {
            if (mark.text.starts_with(text)) return &mark;
        }
    }
    return nullptr;
}

std::vector<std::string> key_of(const Figure& figure) {
    std::vector<std::string> names;
    for (const Curve& curve : figure.curves) {
        if (!curve.name.empty()) names.push_back(curve.name);
    }
    return names;
}

TEST(StudyFigure, NamesEverySetting) {
    for (const study::Result& result : all_results()) {
        const std::string script = gnuplot_script(app::figure_of(result));
        for (const study::SettingResult& setting : result.settings) {
            EXPECT_THAT(script, HasSubstr(setting.series)) << result.title;
            EXPECT_THAT(script, HasSubstr(setting.label)) << result.title;
        }
    }
}

TEST(StudyFigure, NoLabelLiesOnAnotherAndNoneIsLeftOut) {
    for (const study::Result& result : all_results()) {
        const Figure figure = app::figure_of(result);
        const app::Page page(figure);
        std::size_t wanted = 0;
        for (const Curve& curve : figure.curves)
            wanted +=
                static_cast<std::size_t>(std::ranges::count_if(curve.marks, [](const Mark& mark) { return !mark.text.empty(); }));
        EXPECT_EQ(page.labels().size(), wanted) << result.title;
        for (const app::PlacedLabel& one : page.labels()) {
            EXPECT_FALSE(page.key() && one.box.meets(*page.key())) << result.title << ": " << one.text;
            const auto meeting = std::ranges::count_if(
                page.labels(), [&](const app::PlacedLabel& other) { return &one != &other && one.box.meets(other.box); });
            EXPECT_EQ(meeting, 0) << result.title << ": " << one.text;
        }
    }
}

TEST(StudyFigure, ShowsErrorOverTimeBothLogarithmic) {
    const Figure figure = app::figure_of(three_settings());
    EXPECT_EQ(figure.x.scale, app::Scale::logarithmic);
    EXPECT_EQ(figure.y.scale, app::Scale::logarithmic);
    const Mark* rod = mark_of(figure, "rod");
    ASSERT_NE(rod, nullptr);
    EXPECT_DOUBLE_EQ(rod->at.x, 730.0);    // [µs]
    EXPECT_DOUBLE_EQ(rod->at.y, 0.42);     // [%]
    ASSERT_TRUE(rod->reach.has_value());
    EXPECT_DOUBLE_EQ(rod->reach->second, 1.35 * 730.0);    // its 99th percentile
}

TEST(StudyFigure, DrawsOneMillisecondAndOneAndFivePerCent) {
    const Figure figure = app::figure_of(three_settings());
    ASSERT_EQ(figure.x.guides.size(), 1);
    EXPECT_EQ(figure.x.guides[0].at, 1000.0);    // [µs]
    EXPECT_EQ(figure.x.guides[0].text, "1 ms");
    ASSERT_EQ(figure.y.guides.size(), 2);
    EXPECT_EQ(figure.y.guides[0].text, "1 %");
    EXPECT_EQ(figure.y.guides[1].text, "5 %");
    for (const study::Result& result : all_results()) {
        const Figure any = app::figure_of(result);
        for (const app::Axis* axis : {&any.x, &any.y}) {
            for (const app::Guide& guide : axis->guides) {
                EXPECT_GT(guide.at, axis->least) << result.title;
                EXPECT_LT(guide.at, axis->greatest) << result.title;
            }
        }
    }
}

TEST(StudyFigure, NumbersStandAtDecades) {
    const Figure figure = app::figure_of(many_settings());
    std::vector<std::string> times, errors;
    for (const app::Tick& tick : figure.x.ticks) {
        if (!tick.text.empty()) times.push_back(tick.text);
    }
    for (const app::Tick& tick : figure.y.ticks) {
        if (!tick.text.empty()) errors.push_back(tick.text);
    }
    EXPECT_THAT(times, ElementsAre("100 µs", "1 ms", "10 ms", "100 ms"));
    EXPECT_THAT(errors, ElementsAre("0.01 %", "0.1 %", "1 %", "10 %"));
}

TEST(StudyFigure, ASeriesOfOneSettingIsNamedAtItsPointNotInTheKey) {
    EXPECT_THAT(key_of(app::figure_of(three_settings())), ElementsAre("Pareto front (filled markers)"));
    EXPECT_THAT(key_of(app::figure_of(fast_answers())), ElementsAre("explicit", "winkler", "Pareto front (filled markers)"));
}

TEST(StudyFigure, TheFrontIsStairsThroughItsSettingsWhoseMarkersAreFilled) {
    const study::Result result = fast_answers();
    const Figure figure = app::figure_of(result);
    const Curve& front = figure.curves.back();
    ASSERT_EQ(front.look, app::Look::band);
    for (const study::SettingResult& setting : result.settings) {
        const Mark* mark = mark_of(figure, setting.label.empty() ? setting.series : setting.label);
        ASSERT_NE(mark, nullptr);
        EXPECT_EQ(mark->filled, setting.on_front) << setting.name();
        const bool drawn = std::ranges::any_of(
            front.points, [&](const app::Point& point) { return point.x == mark->at.x && point.y == mark->at.y; });
        EXPECT_EQ(drawn, setting.on_front) << setting.name();
    }
    for (std::size_t i = 1; i < front.points.size(); ++i) {
        EXPECT_GE(front.points[i].x, front.points[i - 1].x);
        EXPECT_LE(front.points[i].y, front.points[i - 1].y);
    }
}

TEST(StudyFigure, SeriesWithReferencesOfTheirOwnHaveNoFrontInCommon) {
    study::Result result = fast_answers();
    result.own_references = true;
    const Figure figure = app::figure_of(result);
    for (const Curve& curve : figure.curves) EXPECT_NE(curve.look, app::Look::band);
    EXPECT_THAT(figure.notes, Contains(HasSubstr("of its series")));
}

TEST(StudyFigure, WhatTheAxesDoNotReachStandsAtTheirEdge) {
    const Figure figure = app::figure_of(odd_settings());
    const Mark *exact = nullptr, *wild = mark_of(figure, "250 Hz"), *reference = mark_of(figure, "reference");
    for (const Curve& curve : figure.curves) {
        if (curve.name == "rigid") exact = &curve.marks.front();
    }
    ASSERT_NE(exact, nullptr);
    ASSERT_NE(wild, nullptr);
    ASSERT_NE(reference, nullptr);
    EXPECT_EQ(exact->beyond, Beyond::below);
    EXPECT_EQ(reference->beyond, Beyond::below);
    EXPECT_EQ(wild->beyond, Beyond::above);
    EXPECT_EQ(wild->text, "250 Hz, 4.1e9 %");
    for (const Mark* mark : {exact, wild, reference}) {
        EXPECT_GT(mark->at.y, figure.y.least);
        EXPECT_LT(mark->at.y, figure.y.greatest);
    }
}

TEST(StudyFigure, ASettingThatFailedBreaksItsLineAndIsNamedBelow) {
    const Figure figure = app::figure_of(many_settings());
    EXPECT_THAT(figure.notes, Contains("Not shown (never punctured): beam_column, 250 Hz."));
    EXPECT_THAT(figure.notes, Contains("† the machine had other work."));
    EXPECT_EQ(mark_of(figure, "250 Hz"), nullptr);
    EXPECT_TRUE(std::isnan(figure.curves[1].points.front().x));
    EXPECT_THAT(gnuplot_script(figure), Not(HasSubstr("nan")));
}

TEST(StudyFigure, WhereNothingIsTimedEachSettingHasARowWithItsError) {
    const study::Result result = nothing_timed();
    const Figure figure = app::figure_of(result);
    EXPECT_EQ(figure.x.scale, app::Scale::logarithmic);
    ASSERT_EQ(figure.y.ticks.size(), result.settings.size() - 1);    // one failed
    for (std::size_t i = 0; i < figure.y.ticks.size(); ++i) EXPECT_EQ(figure.y.ticks[i].text, result.settings[i].name());
    EXPECT_EQ(figure.x.label, "Error, median of 200 cases (whisker to the worst)");
    EXPECT_THAT(figure.notes, Contains("Not shown (asks for no tissue): euler."));
}

TEST(StudyFigure, NothingToDrawIsAPictureAllTheSame) {
    study::Result empty = three_settings();
    empty.settings.clear();
    EXPECT_THAT(gnuplot_script(app::figure_of(empty)), Not(HasSubstr("inf")));
    study::Result failed = three_settings();
    for (study::SettingResult& setting : failed.settings) setting.error.judged = std::numeric_limits<double>::infinity();
    EXPECT_THAT(gnuplot_script(app::figure_of(failed)), Not(HasSubstr("inf")));
}

/// A folder of our own, gone with its files.
class Pictures : public testing::Test {
protected:
    Pictures() {
        std::string pattern = (std::filesystem::temp_directory_path() / "stylet-pictures-XXXXXX").string();
        folder_ = mkdtemp(pattern.data());
    }
    ~Pictures() override {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    std::filesystem::path folder_;
};

TEST_F(Pictures, OfEveryResultAreDrawn) {
    constexpr std::uintmax_t least = 8000;    // [bytes] an empty canvas stays well below
    int i = 0;
    study::Result empty = three_settings();
    empty.settings.clear();
    std::vector<study::Result> results = all_results();
    for (const study::Result& result : results) {
        const app::PictureFiles files = app::draw_study(result, folder_ / "sub" / std::to_string(++i));
        EXPECT_GT(file_size(files.png), least) << result.title;
        EXPECT_GT(file_size(files.svg), least) << result.title;
    }
    EXPECT_TRUE(exists(app::draw_study(empty, folder_ / "empty").png));
}

}    // namespace
}    // namespace stylet::study_pictures
