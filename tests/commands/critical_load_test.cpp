// `stylet critical-load`: what it answers. What it refuses is critical_load_wrong_test.cpp's.
#include "tests/commands/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace stylet::commands {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

constexpr double four_digits = 5e-5;    // relative: half a unit of the fourth

/// Runs `stylet critical-load … --json -` and reads what it prints.
json loads(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "critical-load");
    arguments.insert(arguments.end(), {"--json", "-"});
    const Outcome outcome = Bench().stylet(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.code == 0 ? json::parse(outcome.out) : json();
}

/// A picture is long: a test that fails does not print it.
bool shows(const std::string& svg, const std::string& what) {
    return svg.find(what) != std::string::npos;
}

constexpr const char* square = "<use xlink:href='#gpPt3' transform=";    // gnuplot's marker, drawn

/// Eq. (1) of a solid needle clamped at its base and free at its tip, 200 GPa.
double clamped_free(double radius, double length) {
    const double bending_stiffness = 200e9 * std::numbers::pi * std::pow(radius, 4) / 4.0;
    return std::numbers::pi * std::numbers::pi * bending_stiffness / (4.0 * length * length);
}

TEST(CriticalLoad, GivesEulersLoadsOfFigure3ToFourDigits) {
    const json by_radius = loads({paper("fig3"), "--vary", "needle.radius=0.1..1mm", "--points", "10"});
    const json by_length = loads({paper("fig3"), "--vary", "needle.length=10..200mm", "--points", "20"});
    double worst = 0.0;
    const auto compare = [&](const json& figure, const auto& expected) {
        const json& scene = figure["scenes"][0];
        ASSERT_EQ(scene["models"].size(), 2u);    // euler and finite elements
        for (const json& model : scene["models"]) {
            for (std::size_t i = 0; i < scene["axis"].size(); ++i) {
                const double off =
                    std::abs(model["load"][i].get<double>() / expected(1e-3 * scene["axis"][i].get<double>()) - 1.0);
                EXPECT_LT(off, four_digits) << model["model"] << " at " << scene["axis"][i];
                worst = std::max(worst, off);
            }
        }
    };
    compare(by_radius, [](double radius) { return clamped_free(radius, 0.1); });
    compare(by_length, [](double length) { return clamped_free(0.3e-3, length); });
    std::printf("Fig. 3: both models within %.1e of Eq. (1)\n", worst);
}

TEST(CriticalLoad, GivesTables1And2InOneCommand) {
    std::vector<std::string> arguments;
    for (int row = 1; row <= 6; ++row) arguments.push_back(paper("table1_row" + std::to_string(row)));
    for (int row = 1; row <= 4; ++row) arguments.push_back(paper("table2_row" + std::to_string(row)));
    arguments.insert(arguments.end(), {"--depth", "50 mm", "--reference", (scene_folder / "paper/tables.csv").string(), "--model",
                                       "winkler", "--model", "foundation,form=consistent"});
    const json tables = loads(arguments);
    ASSERT_EQ(tables["scenes"].size(), 10u);
    // The paper's own mesh noise is 1 to 2 %; its last row lies above the load of the stiffest layer alone, which can't be.
    constexpr double noise = 0.02, last_row = 0.06;
    for (const json& scene : tables["scenes"]) {
        const json& winkler = scene["models"][0];
        const double deviation = winkler["deviation"];
        EXPECT_LT(std::abs(deviation), &scene == &tables["scenes"].back() ? last_row : noise) << scene["title"];
        std::printf("%s: %.3f N, winkler %+.1f %%, foundation %+.1f %%\n", scene["title"].get<std::string>().c_str(),
                    scene["reference"].get<double>(), 100.0 * deviation, 100.0 * scene["models"][1]["deviation"].get<double>());
    }
}

TEST(CriticalLoad, PutsScenesOfOnePointIntoOneTableWithTheKnownLoads) {
    const Outcome tables = Bench().stylet({"critical-load", paper("table1_row1"), paper("table1_row2"), "--depth", "50mm",
                                           "--reference", (scene_folder / "paper/tables.csv").string(), "--model", "winkler",
                                           "--model", "foundation,form=printed", "--model", "foundation,form=consistent"});
    EXPECT_EQ(tables.code, 0) << tables.err;
    EXPECT_THAT(tables.out, StartsWith("Critical loads with 50 mm inserted\n"));
    EXPECT_THAT(tables.out, ContainsRegex("scene +known +winkler +foundation +foundation\n +form=printed +form=consistent\n"));
    EXPECT_THAT(tables.out, ContainsRegex("table1_row1 +7.000 N +7.04[0-9] N +\\+0.6 % +2.682 N +-61.7 % +6.959 N +-0.6 %\n"));
}

TEST(CriticalLoad, GivesBackTheStiffnessThatALoadWasCalculatedFrom) {
    const json column = loads({paper("table1_row1"), "--depth", "50 mm", "--stiffness", "--model", "foundation"});
    EXPECT_NEAR(column["scenes"][0]["models"][0]["stiffness"][0], 5629.129, 5629.129 * 1e-9);    // rounding alone
}

TEST(CriticalLoad, GivesTheFoundationStiffnessOfFigure4b) {
    const json figure = loads({paper("fig4b"), "--depth", "50 mm", "--stiffness", "--vary",
                               "tissue.layers[0].youngs_modulus=30..80kPa", "--points", "6"});
    const json& stiffness = figure["scenes"][0]["models"][0]["stiffness"];
    constexpr double plane = 0.04;    // the block by plane strain, against a three-dimensional one: 2.3 to 3.3 %
    EXPECT_EQ(figure["axis"]["unit"], "kPa");
    for (const auto& [point, known] : {std::pair{0, 5629.129}, {3, 7792.546}, {5, 8915.707}}) {
        EXPECT_NEAR(stiffness[point], known, plane * known);
        std::printf("%g kPa: %.0f Pa, the paper %.0f Pa\n", figure["scenes"][0]["axis"][point].get<double>(),
                    stiffness[point].get<double>(), known);
    }
}

TEST(CriticalLoad, SaysWhetherTheNeedleBucklesBeforeItsTipPunctures) {
    const Bench bench;
    const Outcome bucklers = bench.stylet({"critical-load", paper("fig10a_l200")});
    EXPECT_THAT(bucklers.out,
                HasSubstr("  euler: the needle buckles at 0.6422 N, before its tip punctures at 1.000 N. Inside it bears "
                          "more than that from"));
    const Outcome puncturers = bench.stylet({"critical-load", paper("fig10a_l150")});
    EXPECT_THAT(puncturers.out,
                HasSubstr("  euler: the tip punctures at 1.000 N, before the needle buckles at 1.142 N. Inside, cutting"));
    const json answer = loads({paper("fig10a_l200")})["scenes"][0]["models"][0];
    EXPECT_EQ(answer["buckles_first"], true);
    EXPECT_NEAR(answer["load_at_surface"], 0.64224, 0.64224 * four_digits);
    ASSERT_EQ(answer["crossings"].size(), 1u);
    // 20.19 EI/(L - d)^2 = 1 N, found by halving to a millionth of 3 mm.
    const double crossing = 200.0 - 1e3 * std::sqrt(20.190728556 * 200e9 * std::numbers::pi * std::pow(0.3e-3, 4) / 4.0);
    EXPECT_NEAR(answer["crossings"][0], crossing, 1e-5);
}

/// Once in, it is cutting and friction that push back: 2 pi r J_c + f d against 20.19 EI/(L - d)^2.
TEST(CriticalLoad, SaysWhereTheNeedleBucklesInside) {
    const std::vector<std::string> sticky{paper("fig10a_l150"), "--set", "effects[1].per_length=60 N/m"};
    const json scene = loads(sticky)["scenes"][0];
    const json crossings = scene["models"][0]["inside_crossings"];
    ASSERT_EQ(crossings.size(), 2u);
    for (const json& crossing : crossings) {
        const double inserted = 1e-3 * crossing.get<double>();
        const double bears = 20.190728556 * 200e9 * std::numbers::pi * std::pow(0.3e-3, 4) / 4.0 / std::pow(0.15 - inserted, 2);
        const double asks = 2.0 * std::numbers::pi * 0.3e-3 * 164.0 + 60.0 * inserted;
        EXPECT_NEAR(bears, asks, asks * four_digits) << crossing;
        std::printf("buckles inside from or to %.4f mm, at %.4f N\n", crossing.get<double>(), bears);
    }
    EXPECT_EQ(scene["models"][0]["buckles_first"], false);
    std::vector<std::string> command{"critical-load"};
    command.insert(command.end(), sticky.begin(), sticky.end());
    EXPECT_THAT(Bench().stylet(command).out, HasSubstr("Inside, cutting and friction ask for 0.3091\n  N to 9.309 N: it buckles "
                                                       "from 20.3 mm to 78.43 mm.\n"));
    EXPECT_THAT(Bench().stylet({"critical-load", paper("fig9")}).out, HasSubstr(": it buckles from 38.83 mm to 139.6 mm.\n"));
    EXPECT_THAT(Bench().stylet({"critical-load", paper("fig10a_l150")}).out,
                HasSubstr("cutting and friction ask for 0.3091\n  N to 1.059 N, which it bears.\n"));
}

TEST(CriticalLoad, AddsTheFrictionOfEachLayerUpToTheTip) {
    const json scene = loads({paper("fig9"), "--depth", "30..40mm", "--points", "2"})["scenes"][0];
    const double cuts = 2.0 * std::numbers::pi * 0.3e-3 * 164.0;
    EXPECT_NEAR(scene["insertion_force"][0], cuts + 5.0 * 0.03, 1e-12);
    EXPECT_NEAR(scene["insertion_force"][1], cuts + 5.0 * 0.03 + 60.0 * 0.01, 1e-12);
}

TEST(CriticalLoad, SpeaksOfThePartOfTheInsertionThatItWasAskedFor) {
    const Outcome part = Bench().stylet({"critical-load", paper("fig10a_l200"), "--depth", "10..20mm"});
    EXPECT_THAT(part.out, HasSubstr("From 10 mm to 20 mm it nowhere bears that.\n"));
    EXPECT_THAT(part.out, HasSubstr("From 10 mm to 20 mm, cutting and friction ask for 0.3591 N to 0.4091 N, which it bears.\n"));
    const Outcome beginning = Bench().stylet({"critical-load", paper("fig10a_l200"), "--depth", "0..60mm"});
    EXPECT_THAT(beginning.out, HasSubstr("at 1.000 N. It bears more than that from 39.72 mm on.\n  Up to 60 mm, cutting"));
    const Outcome later = Bench().stylet({"critical-load", paper("fig10a_l200"), "--depth", "80..90mm"});
    EXPECT_THAT(later.out, HasSubstr("From 80 mm to 90 mm it bears more than\n  that. From 80 mm to 90 mm, cutting"));
}

TEST(CriticalLoad, SpeaksOfTheOneDepthFirst) {
    const Outcome one = Bench().stylet({"critical-load", paper("fig10a_l200"), "--depth", "30 mm"});
    EXPECT_THAT(one.out, HasSubstr("euler: with 30 mm inserted the needle buckles at 0.8889 N, and cutting and friction ask for "
                                   "0.4591 N, which it bears.\n  On the surface the needle buckles at 0.6422 N, before its tip "
                                   "punctures at 1.000 N.\n"));
    const Outcome all = Bench().stylet({"critical-load", paper("table1_row1"), "--depth", "50mm", "--model", "euler"});
    EXPECT_THAT(all.out, HasSubstr("euler: with 50 mm inserted none of the needle is in air, of which alone this model knows."));
}

TEST(CriticalLoad, OfNoNeedleInAirIsNoNumberWhereAModelKnowsAirAlone) {
    const json models = loads({paper("table1_row1"), "--model", "euler", "--model", "winkler"})["scenes"][0]["models"];
    EXPECT_EQ(models[0]["load"].back(), nullptr);
    EXPECT_TRUE(models[0]["load"].front().is_number());
    EXPECT_TRUE(models[1]["load"].back().is_number());    // it knows the tissue
    const Outcome csv = Bench().stylet({"critical-load", paper("table1_row1"), "--model", "euler", "--csv", "-"});
    EXPECT_THAT(csv.out, ContainsRegex("table1_row1,50,inf,inf,\n$"));
}

TEST(CriticalLoad, ComparesScenesOfOneDepthWithWhatTheyHaveToBear) {
    const Outcome inside = Bench().stylet({"critical-load", paper("fig10a_l200"), paper("fig10a_l300"), "--depth", "30mm"});
    EXPECT_THAT(inside.out, ContainsRegex("scene +insertion +euler\n +fig10a_l200 +0.4591 N +0.8889 N +bears\n"
                                          " +fig10a_l300 +0.4591 N +0.3524 N +buckles\n"));
    const Outcome surface = Bench().stylet({"critical-load", paper("fig10a_l150"), paper("fig10a_l200"), "--depth", "0mm"});
    EXPECT_THAT(surface.out, ContainsRegex("scene +puncture +euler\n +fig10a_l150 +1.000 N +1.142 N +bears\n"
                                           " +fig10a_l200 +1.000 N +0.6422 N +buckles\n"));
}

TEST(CriticalLoad, SaysThatAKeyPlaysNoPart) {
    const Outcome outcome =
        Bench().stylet({"critical-load", paper("fig10a_l200"), "--vary", "tissue.layers[0].youngs_modulus=1..6kPa"});
    EXPECT_THAT(outcome.out, HasSubstr("the load of 0.6422 N does not depend on tissue.layers[0].youngs_modulus.\n"));
}

TEST(CriticalLoad, ComparesAlongAVariedKeyAtADepthWithWhatTakesTheNeedleOn) {
    const Outcome outcome =
        Bench().stylet({"critical-load", paper("fig10a_l200"), "--depth", "30mm", "--vary", "needle.radius=0.2..0.6mm"});
    EXPECT_THAT(outcome.out, HasSubstr("euler: the needle buckles before it goes on where needle.radius is up to 0.2463 mm.\n"));
}

TEST(CriticalLoad, VariesAParameterOfAModelThatTheSceneHasNoMapFor) {
    const json figure = loads({paper("fig10a_l200"), "--model", "euler", "--model", "winkler,foundation_modulus=vesic", "--vary",
                               "needle.buckling.winkler.elements=8..10", "--points", "3"});
    EXPECT_EQ(figure["scenes"][0]["axis"], json::parse("[8.0, 9.0, 10.0]"));
}

TEST(CriticalLoad, TellsScenesOfOneNameByTheirFolders) {
    const Bench bench;
    const char* const scene =
        "stylet: 1\ntitle: Rigid\nneedle: {type: rigid, length: 100 mm, gauge: 22G, youngs_modulus: 200 GPa, "
        "ends: clamped-free}\nrun: {rate: 1 kHz, duration: 1 s}\n";
    for (const char* folder : {"a", "b"}) std::filesystem::create_directory(bench.path(folder));
    for (const char* file : {"a/x.yaml", "b/x.yaml", "b/y.yaml"}) bench.write(file, scene);
    const Outcome outcome = bench.stylet({"critical-load", "a/x.yaml", "b/x.yaml", "b/y.yaml", "--model", "euler", "--csv", "-"});
    EXPECT_THAT(outcome.out, ContainsRegex("\na/x,.*\nb/x,.*\ny,"));
    const Outcome twice = bench.stylet({"critical-load", "a/x.yaml", "a/../a/x.yaml", "--model", "euler"});
    EXPECT_EQ(twice.code, 3);
    EXPECT_EQ(twice.err, "a/../a/x.yaml: found this scene a second time, wanted each once\n");
}

TEST(CriticalLoad, TakesAGaugeInPlaceOfAScenesRadiiAndRadiiInPlaceOfAGauge) {
    const Bench bench;
    const Outcome gauge = bench.stylet({"critical-load", paper("fig3"), "--set", "needle.gauge=22G"});
    EXPECT_THAT(gauge.out, HasSubstr("radius 0.3588 mm, inner radius 0.2065 mm (22G)"));
    bench.write("tube.yaml",
                "stylet: 1\ntitle: Tube\nneedle: {type: rigid, length: 100 mm, gauge: 22G, youngs_modulus: 200 GPa, ends: "
                "clamped-free}\nrun: {rate: 1 kHz, duration: 1 s}\n");
    const Outcome solid = bench.stylet({"critical-load", "tube.yaml", "--model", "euler", "--set", "needle.radius=0.3 mm"});
    EXPECT_THAT(solid.out, HasSubstr("100 mm long, radius 0.3 mm, 200 GPa"));
}

TEST(CriticalLoad, WritesLoadsOfAnySizeInFourDigits) {
    const Outcome tiny = Bench().stylet({"critical-load", paper("fig3"), "--set", "needle.radius=20 um"});
    EXPECT_THAT(tiny.out, HasSubstr("euler: the needle buckles at 6.201 µN.\n"));
    const Outcome least = Bench().stylet({"critical-load", paper("fig3"), "--set", "needle.radius=1 um"});
    EXPECT_THAT(least.out, HasSubstr("euler: the needle buckles at 3.876e-11 N.\n"));
}

TEST(CriticalLoad, WritesKnownLoadsAndDeviationsAsCsv) {
    const Bench bench;
    bench.write("known.csv", "\xEF\xBB\xBFscene,load [N]\nfig3,1\n");    // as a spreadsheet writes it
    const Outcome outcome = bench.stylet(
        {"critical-load", paper("fig3"), "--depth", "0mm", "--model", "euler", "--reference", "known.csv", "--csv", "-"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, ContainsRegex("euler \\[N\\],known \\[N\\],euler deviation\nfig3,0,inf,inf,0.31[0-9]+,1,-0.68"));
}

TEST(CriticalLoad, SaysItOfAVariedKeyToo) {
    const Outcome outcome = Bench().stylet({"critical-load", paper("fig10a_l200"), "--vary", "needle.radius=0.2..0.6mm"});
    EXPECT_THAT(outcome.out, HasSubstr("euler: the needle buckles before its tip punctures where needle.radius is up to 0.33"));
}

TEST(CriticalLoad, FollowsTheWholeInsertionUnlessToldWhere) {
    const json scene = loads({paper("fig10a_l200")})["scenes"][0];
    EXPECT_EQ(scene["axis"].size(), 51u);
    EXPECT_EQ(scene["axis"].front(), 0.0);
    EXPECT_DOUBLE_EQ(scene["axis"].back(), 150.0);    // the tissue's height: the needle is longer
    EXPECT_EQ(scene["models"][0]["load"].size(), 51u);
    const json part = loads({paper("fig10a_l200"), "--depth", "1..5cm", "--points", "3"});
    EXPECT_EQ(part["axis"]["unit"], "cm");
    EXPECT_EQ(part["scenes"][0]["axis"], json::parse("[1.0, 3.0, 5.0]"));
}

TEST(CriticalLoad, OfANeedleInAirIsOneLoad) {
    const json scene = loads({paper("fig3")})["scenes"][0];
    EXPECT_EQ(scene["axis"], json::parse("[0.0]"));
    EXPECT_EQ(scene["puncture_force"], json::parse("[null]"));
    EXPECT_EQ(scene["models"][0]["buckles_first"], nullptr);
}

TEST(CriticalLoad, AsksTheScenesModelAndEveryOtherThatHasAMap) {
    const json models = loads({paper("table1_row1"), "--depth", "50 mm"})["scenes"][0]["models"];
    std::vector<std::string> names;
    for (const json& model : models) names.push_back(model["model"]);
    EXPECT_THAT(names, testing::ElementsAre("winkler", "foundation", "layered_explicit"));
}

TEST(CriticalLoad, TakesAModelsParametersFromItsMapAndThenFromTheCommand) {
    const json models =
        loads({paper("table1_row1"), "--depth", "50 mm", "--model", "foundation", "--model", "foundation,form=printed", "--model",
               "winkler,given=[{layer: soft, modulus: 1 kPa}, {layer: medium, modulus: 1 kPa}]"})["scenes"][0]["models"];
    EXPECT_GT(models[0]["load"][0], models[1]["load"][0]);
    EXPECT_EQ(models[1]["model"], "foundation form=printed");
    EXPECT_LT(models[2]["load"][0], 3.0);    // √(kEI) = 1.13 N, and some more
}

TEST(CriticalLoad, NeedsNoBucklingSectionWhereAModelIsNamed) {
    const Bench bench;
    bench.write("rigid.yaml",
                "stylet: 1\ntitle: Rigid\nneedle: {type: rigid, length: 100 mm, gauge: 22G, youngs_modulus: 200 GPa, "
                "ends: clamped-free}\nrun: {rate: 1 kHz, duration: 1 s}\n");
    const Outcome outcome = bench.stylet({"critical-load", "rigid.yaml", "--model", "euler", "--json", "rigid.json"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(
        outcome.out,
        HasSubstr(
            "needle   rigid, 100 mm long, radius 0.3588 mm, inner radius 0.2065 mm (22G), 200 GPa, clamped-free\n           "
            "given no buckling model by its scene: in a run it buckles by itself or not at all\n"));
    const json scene = json::parse(bench.read("rigid.json"))["scenes"][0];
    const double tube = clamped_free(0.3588e-3, 0.1) - clamped_free(0.2065e-3, 0.1);
    EXPECT_NEAR(scene["models"][0]["load"][0], tube, tube * four_digits);
    EXPECT_EQ(scene["needle"]["gauge"], "22G");
}

TEST(CriticalLoad, TakesOverridesAndPluginFolders) {
    const json scene = loads({paper("fig3"), "--set", "needle.length=200 mm", "--plugin-dir", TEST_PLUGIN_FOLDER, "--model",
                              "euler", "--model", "odd_column,answer=infinity"})["scenes"][0];
    EXPECT_NEAR(scene["models"][0]["load"][0], clamped_free(0.3e-3, 0.2), clamped_free(0.3e-3, 0.2) * four_digits);
    EXPECT_EQ(scene["models"][1]["load"][0], nullptr);    // JSON has no infinity
    const Outcome text = Bench().stylet(
        {"critical-load", paper("fig3"), "--plugin-dir", TEST_PLUGIN_FOLDER, "--model", "odd_column,answer=infinity"});
    EXPECT_THAT(text.out, ContainsRegex("0 mm +unlimited\n\n.*: the needle never buckles.\n"));
}

TEST(CriticalLoad, WritesEveryPointAsCsv) {
    const Bench bench;
    const Outcome outcome = bench.stylet({"critical-load", paper("fig3"), "--vary", "needle.radius=0.1..1mm", "--csv", "-"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out,
                StartsWith("scene,needle.radius [mm],puncture [N],insertion [N],euler [N],winkler [N]\nfig3,0.1,inf,inf,0.0038"));
    EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 52);
    EXPECT_EQ(bench.stylet({"critical-load", paper("fig10a_l200"), "--csv", "all.csv"}).code, 0);
    EXPECT_THAT(bench.read("all.csv"),
                StartsWith("scene,inserted [mm],puncture [N],insertion [N],euler [N]\nfig10a_l200,0,1,0.309"));
}

TEST(CriticalLoad, PrintsOfManyPointsSome) {
    const Outcome many = Bench().stylet({"critical-load", paper("fig10a_l200")});
    EXPECT_THAT(many.out,
                AllOf(HasSubstr("\n  0 mm "), HasSubstr("\n  150 mm "), HasSubstr("  11 of 51 points; --csv FILE has all\n")));
    const Outcome few = Bench().stylet({"critical-load", paper("fig10a_l200"), "--points", "21"});
    EXPECT_THAT(few.out, Not(HasSubstr("--csv")));
}

TEST(CriticalLoad, DrawsClosedFormAndFiniteElementsSoThatBothAreSeen) {
    const Bench bench;
    const Outcome plot =
        bench.stylet({"critical-load", paper("fig3"), "--vary", "needle.radius=0.1..1mm", "--plot", "out/fig3a"});
    EXPECT_EQ(plot.code, 0) << plot.err;
    EXPECT_THAT(plot.out, HasSubstr("out/fig3a.svg\nout/fig3a.png\n"));
    const std::string svg = bench.read("out/fig3a.svg");
    for (const char* text : {">euler<", ">winkler<", "needle.radius (mm)", "Critical load (N)", "Fig. 3: a needle in air"})
        EXPECT_TRUE(shows(svg, text)) << text;
    EXPECT_TRUE(shows(svg, square));    // over the line
    EXPECT_THAT(bench.read("out/fig3a.png"), StartsWith("\x89PNG"));
}

TEST(CriticalLoad, DrawsTheForceThatPuncturesBesideTheCurve) {
    const Bench bench;
    ASSERT_EQ(bench.stylet({"critical-load", paper("fig10a_l200"), "--plot", "l200.png"}).code, 0);
    const std::string svg = bench.read("l200.svg");
    for (const char* text : {"tip punctures", "cutting and friction", "Inserted length (mm)"})
        EXPECT_TRUE(shows(svg, text)) << text;
    EXPECT_FALSE(shows(svg, square));
    EXPECT_TRUE(bench.has("l200.png"));
}

TEST(CriticalLoad, LeavesRoomForWideNumbersBesideTheAxis) {
    const Bench bench;
    const auto label_at = [&](const char* modulus) {    // [pixels] from the left, of the y axis' label
        const Outcome plot = bench.stylet({"critical-load", paper("fig3"), "--vary", "needle.radius=1..6mm", "--set",
                                           std::string("needle.youngs_modulus=") + modulus, "--plot", "wide"});
        EXPECT_EQ(plot.code, 0) << plot.err;
        const std::string svg = bench.read("wide.svg");
        const std::size_t text = svg.find("Critical load (N)"), place = svg.rfind("translate(", text);
        return std::stod(svg.substr(place + std::string("translate(").size()));
    };
    constexpr double a_line = 22.0;    // [pixels] of 16-pixel letters, turned on their side, that end at the place
    for (const char* modulus : {"1 GPa", "1000 GPa", "200000 GPa"}) EXPECT_GT(label_at(modulus), a_line) << modulus;
}

TEST(CriticalLoad, SaysOfACurveAloneWhatItIs) {
    const Bench bench;
    ASSERT_EQ(bench
                  .stylet({"critical-load", paper("table1_row1"), "--depth", "50mm", "--model", "winkler", "--vary",
                           "needle.radius=0.2..0.4mm", "--points", "3", "--plot", "alone"})
                  .code,
              0);
    EXPECT_TRUE(shows(bench.read("alone.svg"), ", winkler, 50 mm inserted<"));
}

TEST(CriticalLoad, DrawsACurveOfOnePointAsAMarker) {
    const Bench bench;
    const Outcome plot =
        bench.stylet({"critical-load", paper("fig3"), paper("fig10a_l200"), "--model", "euler", "--plot", "one"});
    EXPECT_EQ(plot.code, 0) << plot.err;
    EXPECT_TRUE(shows(bench.read("one.svg"), "<use xlink:href='#gpPt"));
}

TEST(CriticalLoad, AsksAtTheBordersOfLayersToo) {
    const json axis = loads({paper("fig9"), "--depth", "0..50mm", "--points", "5"})["scenes"][0]["axis"];
    EXPECT_EQ(axis, json::parse("[0.0, 12.5, 25.0, 30.0, 37.5, 50.0]"));
    EXPECT_EQ(loads({paper("fig9"), "--depth", "0..6cm", "--points", "3"})["scenes"][0]["axis"], json::parse("[0.0, 3.0, 6.0]"));
}

TEST(CriticalLoad, DrawsSeveralScenesIntoOnePicture) {
    const Bench bench;
    const Outcome plot = bench.stylet({"critical-load", paper("fig10a_l200"), paper("fig10a_l300"), "--plot", "both"});
    EXPECT_EQ(plot.code, 0) << plot.err;
    const std::string svg = bench.read("both.svg");
    for (const char* text : {">L = 200 mm<", ">L = 300 mm<", ">euler<"}) EXPECT_TRUE(shows(svg, text)) << text;
}

}    // namespace
}    // namespace stylet::commands
