// `stylet critical-load` told what makes no sense: one sentence for each mistake, all of them at once.
#include "tests/commands/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace stylet::commands {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

Outcome asked(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "critical-load");
    return Bench().stylet(arguments);
}

TEST(CriticalLoadRefuses, AWrongCommandLineInASentence) {
    struct Wrong {
        std::vector<std::string> arguments;
        const char* message;
    };
    const Wrong wrongs[] = {
        {{"--depth", "30"},
         "--depth: found '30' without a unit, wanted a length in m such as '25 mm', or an interval such as 0..50mm\n"},
        {{"--depth", "3 kg"}, "--depth: found '3 kg', wanted a length in m such as '25 mm', or an interval such as 0..50mm\n"},
        {{"--depth", "deep"}, "--depth: found 'deep', wanted a quantity such as '30 mm' or an interval such as 0..50mm\n"},
        {{"--depth", "5.."}, "--depth: found '5..', wanted a quantity such as '30 mm' or an interval such as 0..50mm\n"},
        {{"--depth", "nan mm"}, "--depth: found 'nan mm', wanted a quantity such as '30 mm' or an interval such as 0..50mm\n"},
        {{"--depth", "5..2mm"}, "--depth: found '5..2mm', wanted the smaller end first\n"},
        {{"--depth", "5mm..2cm"}, "--depth: found '5mm..2cm', wanted one unit for both ends, such as 0..50mm\n"},
        {{"--vary", "needle.radius"},
         "--vary: found 'needle.radius', wanted KEY=FROM..TO, for instance needle.radius=0.1..1mm\n"},
        {{"--vary", "needle.radius=1mm"},
         "--vary: found 'needle.radius=1mm', wanted an interval such as 0.1..1mm (--set gives one value)\n"},
        {{"--vary", "needle.radius=0.1..1mm", "--depth", "0..5mm"},
         "--depth: found '0..5mm' beside --vary, wanted one depth: a picture has one axis\n"},
        {{"--points", "5", "--depth", "5mm"}, "--points: found one depth, wanted an interval such as --depth 0..50mm\n"},
        {{"--plot", "x", "--depth", "5mm"},
         "--plot: found one point of each curve, wanted an interval such as --depth 0..50mm\n"},
        {{"--reference", "x.csv"},
         "--reference: found no single depth, wanted one such as --depth '50 mm', or --depth '0 mm' of a needle in air\n"},
        {{"--reference", "x.csv", "--vary", "needle.radius=0.1..1mm"},
         "--reference: found --vary, wanted one depth alone: a known load is of one scene\n"},
        {{"--json", "-", "--csv", "-"}, "--csv: found '-' beside --json -, wanted a file for one of them: stdout is one\n"},
        {{"--depth", ""}, "--depth: found '', wanted a value\n"},
        {{"--depth", "1mm", "--depth", "2mm"}, "--depth: found it 2 times, wanted it once\n"},
        {{"--points", "0"}, "--points: found 0, wanted 2 to 10000\n"},
        {{"--plot", "out/"},
         "--plot: found 'out/', wanted what both files' names begin with, such as out/insertion: it draws STEM.svg and "
         "STEM.png\n"},
        {{"--plot", "x.pdf"},
         "--plot: found 'x.pdf', wanted what both files' names begin with, such as out/insertion: it draws STEM.svg and "
         "STEM.png\n"},
        {{"--plot", "-"},
         "--plot: found '-', wanted what both files' names begin with, such as out/insertion: it draws STEM.svg and STEM.png\n"},
        {{"--model", "winkler,elements=8", "--vary", "needle.buckling.winkler.elements=8..16"},
         "--vary: found 'needle.buckling.winkler.elements', which --model winkler,elements=8 sets, wanted one of the two\n"},
        {{"--model", "euler", "--model", "euler"}, "--model: found 'euler' a second time, wanted each once\n"},
        {{"--model", "foundation,form"},
         "--model: found 'foundation,form', wanted NAME or NAME,KEY=VALUE, for instance foundation,form=printed\n"},
        {{"--model", ",form=printed"},
         "--model: found ',form=printed', wanted NAME or NAME,KEY=VALUE, for instance foundation,form=printed\n"},
        {{"--model", "form=printed"},
         "--model: found 'form=printed', wanted NAME or NAME,KEY=VALUE, for instance foundation,form=printed\n"},
    };
    for (const Wrong& wrong : wrongs) {
        std::vector<std::string> arguments{paper("fig10a_l200")};
        arguments.insert(arguments.end(), wrong.arguments.begin(), wrong.arguments.end());
        const Outcome outcome = asked(arguments);
        EXPECT_EQ(outcome.code, 3) << outcome.err;
        EXPECT_EQ(outcome.err, wrong.message);
        EXPECT_THAT(outcome.out, IsEmpty());
    }
    EXPECT_EQ(asked({}).code, 3);
    EXPECT_EQ(asked({paper("fig3"), "--points", "1"}).code, 3);
    EXPECT_EQ(asked({paper("fig3"), "--plugin-dir", "nowhere"}).code, 3);
}

TEST(CriticalLoadRefuses, AllWrongModelsAtOnceWithWhatWasMeant) {
    const Outcome outcome = asked({paper("table1_row1"), "--model", "foundatoin", "--model", "foundation,form=prnted", "--model",
                                   "winkler,elments=8", "--model", "winkler,elements=3 mm", "--model", "friction"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("--model foundatoin: needle.buckling.type: found no plugin 'foundatoin' in "));
    EXPECT_THAT(outcome.err, HasSubstr("; did you mean 'foundation'?\n"));
    EXPECT_THAT(outcome.err,
                HasSubstr("--model foundation,form=prnted: needle.buckling.foundation.form: found 'prnted', wanted one of "
                          "printed, consistent"));
    EXPECT_THAT(outcome.err,
                HasSubstr("--model winkler,elments=8: needle.buckling.winkler.elments: found an unknown key, wanted one of "));
    EXPECT_THAT(outcome.err,
                HasSubstr("--model winkler,elements=3 mm: needle.buckling.winkler.elements: found '3 mm', wanted a whole "));
    EXPECT_THAT(outcome.err,
                HasSubstr("--model friction: needle.buckling.type: 'friction' is an effect, wanted a buckling model\n"));
    EXPECT_THAT(outcome.out, IsEmpty());
}

TEST(CriticalLoadRefuses, AllWrongScenesAtOnceAndEachMistakeOnce) {
    const Bench bench;
    bench.write("bad.yaml", "stylet: 1\ntitle: Bad\nneedle: {type: rigid, length: 5}\nrun: {rate: 1 kHz, duration: 1 s}\n");
    const Outcome outcome = bench.stylet({"critical-load", "bad.yaml", "nowhere.yaml", "--model", "euler", "--model", "winkler"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("bad.yaml:3:31: needle.length"), HasSubstr("nowhere.yaml: found no such file")));
    EXPECT_EQ(outcome.err.find("needle.length: "), outcome.err.rfind("needle.length: "));
}

TEST(CriticalLoadRefuses, ADepthThatTheNeedleCannotHave) {
    const std::string air = paper("fig3"), tissue = paper("fig10a_l200"), short_needle = paper("table1_row1");
    EXPECT_EQ(asked({air, "--depth", "5mm"}).err, air + ": --depth: found '5mm', wanted 0 m (the scene has no tissue)\n");
    EXPECT_EQ(asked({tissue, "--depth", "0..160mm"}).err,
              tissue + ": --depth: found '0..160mm', wanted 0 m to 0.15 m (the tissue's height)\n");
    EXPECT_EQ(asked({short_needle, "--depth", "51mm"}).err,
              short_needle + ": --depth: found '51mm', wanted 0 m to 0.05 m (the needle's length)\n");
    EXPECT_EQ(asked({tissue, "--depth", "-1mm"}).code, 2);
    EXPECT_EQ(asked({short_needle, "--depth", "50mm", "--vary", "needle.length=20..60mm"}).code, 2);
}

TEST(CriticalLoadRefuses, AScenesWithoutWhatBuckles) {
    const std::string patch = (scene_folder / "validation/half_space_patch.yaml").string();
    EXPECT_EQ(asked({patch, "--model", "euler"}).err,
              patch + ": found a scene without a needle, wanted one: only a needle buckles\n");
    const Bench bench;
    bench.write("plain.yaml",
                "stylet: 1\ntitle: Plain\nneedle: {type: rigid, length: 5 mm, radius: 1 mm, youngs_modulus: 1 GPa, ends: "
                "clamped-free}\nrun: {rate: 1 kHz, duration: 1 s}\n");
    EXPECT_EQ(bench.stylet({"critical-load", "plain.yaml"}).err,
              "plain.yaml: found a needle without 'buckling', wanted one, or a model named by --model NAME\n");
}

TEST(CriticalLoadRefuses, AVariedKeyAsItRefusesAnOverride) {
    const std::string scene = paper("fig10a_l200");
    EXPECT_EQ(asked({scene, "--vary", "needle.radius=0.1..1"}).err,
              "--vary needle.radius: found '0.1' without a unit, wanted a length in m such as '25 mm' (needle radius; either "
              "this or `gauge`)\n");
    EXPECT_THAT(asked({scene, "--vary", "needle.radus=0.1..1mm"}).err,
                AllOf(StartsWith("--vary needle.radus: found an unknown key"), HasSubstr("did you mean 'radius'?")));
    EXPECT_EQ(asked({scene, "--vary", "tissue.layers[3].thickness=1..2mm"}).err,
              "--vary tissue.layers[3].thickness: found no item [3], 'tissue.layers' is a list of 1\n");
    EXPECT_THAT(asked({scene, "--vary", "needle.radius=100..300mm"}).err,
                StartsWith("--vary needle.radius: found '200 mm', wanted less than the needle's length"));
    EXPECT_THAT(
        asked({scene, "--set", "needle={type: rigid, length: 20 mm, gauge: 22G, youngs_modulus: 1 GPa, ends: clamped-free}",
               "--model", "euler", "--vary", "needle.radius=0.1..1mm"})
            .err,
        StartsWith("--vary needle.radius: found '0.1 mm', wanted none beside gauge '22G', which says it already"));
}

TEST(CriticalLoadRefuses, PartsOfAWholeNumberAndSaysWhatWouldGo) {
    EXPECT_THAT(asked({paper("fig3"), "--model", "winkler", "--vary", "needle.buckling.winkler.elements=8..64"}).err,
                HasSubstr("; --points 57 goes from 8 to 64 in whole numbers\n"));
}

TEST(CriticalLoadRefuses, AModelThatDoesNotGoWithTheSceneByTheScenesOwnPlace) {
    const Bench bench;
    bench.write("own.yaml",
                "stylet: 1\ntitle: Own\ntissue:\n  type: half_space\n  extent: [1 m, 1 m, 1 m]\n  fixed: bottom\n"
                "  layers: [{name: gel, youngs_modulus: 25 kPa, poisson_ratio: 0.49}]\n"
                "needle: {type: rigid, length: 100 mm, gauge: 22G, youngs_modulus: 200 GPa, ends: clamped-free,\n"
                "         buckling: {type: winkler}}\n"
                "device: {type: recorded_hand, tip_start: [0 mm, 0 mm, 2 mm], motion: [{insert: 1 mm, speed: 1 mm/s}]}\n"
                "coupling: {contact_spacing: 5 mm}\nrun: {rate: 1 kHz}\n");
    EXPECT_THAT(bench.stylet({"critical-load", "own.yaml"}).err,
                StartsWith("own.yaml:9:27: needle.buckling.winkler.foundation_modulus: found none in a scene with a tissue"));
    EXPECT_THAT(bench.stylet({"critical-load", "own.yaml", paper("fig3"), "--model", "winkler"}).err,
                StartsWith("own.yaml:9:27: needle.buckling.winkler.foundation_modulus: found none"));
    EXPECT_THAT(
        bench.stylet({"critical-load", "own.yaml", paper("fig3"), "--model", "foundation,form=printed"}).err,
        StartsWith("own.yaml: --model foundation,form=printed: needle.buckling.foundation.foundation_modulus: found none"));
}

TEST(CriticalLoadRefuses, AStiffnessThatEq3DoesNotKnow) {
    const std::string column = paper("table1_row1"), pinned = paper("fig10a_l200");
    EXPECT_EQ(asked({column, "--stiffness", "--depth", "30mm", "--model", "winkler"}).err,
              column +
                  ": --stiffness: found 0.02 m of needle in air, wanted a needle wholly in tissue (--depth '50 mm'): Eq. (3) "
                  "knows no air\n");
    EXPECT_EQ(asked({pinned, "--stiffness", "--depth", "30mm"}).err,
              pinned + ": --stiffness: found other ends than clamped-free, wanted those: Eq. (3) is of such a column\n");
}

TEST(CriticalLoadRefuses, AReferenceThatIsNoTableOfTheseScenes) {
    struct Wrong {
        const char* text;
        const char* message;
    };
    const Wrong wrongs[] = {
        {"", "known.csv:1: found '', wanted the header 'scene,load [N]'\n"},
        {"# nothing\nscene,load\nfig3,1\n", "known.csv:2: found 'scene,load', wanted the header 'scene,load [N]'\n"},
        {"scene,load [N]\nfig3\n", "known.csv:2: found 'fig3', wanted a scene's name and its load in N, such as fig3,0.314\n"},
        {"scene,load [N]\nfig3,much\n",
         "known.csv:2: found 'fig3,much', wanted a scene's name and its load in N, such as fig3,0.314\n"},
        {"scene,load [N]\nfig3,-1\n",
         "known.csv:2: found 'fig3,-1', wanted a scene's name and its load in N, such as fig3,0.314\n"},
        {"scene,load [N]\nfig3,1\nfig3,2\n", "known.csv:3: found 'fig3,2', wanted each scene once\n"},
        {"scene,load [N]\nfig33,1\n", "known.csv: found no load of 'fig3', wanted one for each scene; did you mean 'fig33'?\n"},
        {"scene,load [N]\nother,1\n", "known.csv: found no load of 'fig3', wanted one for each scene\n"},
    };
    const Bench bench;
    for (const Wrong& wrong : wrongs) {
        bench.write("known.csv", wrong.text);
        const Outcome outcome = bench.stylet({"critical-load", paper("fig3"), "--depth", "0mm", "--reference", "known.csv"});
        EXPECT_EQ(outcome.code, 2);
        EXPECT_EQ(outcome.err, wrong.message);
    }
    EXPECT_EQ(bench.stylet({"critical-load", paper("fig3"), paper("fig9"), "--depth", "0mm", "--reference", "known.csv"}).err,
              "known.csv: found no load of 'fig3', 'fig9', wanted one for each scene\n");
    EXPECT_EQ(bench.stylet({"critical-load", paper("fig3"), "--depth", "0mm", "--reference", "nowhere.csv"}).err,
              "nowhere.csv: found no such file, wanted a table of loads\n");
}

TEST(CriticalLoadRefuses, WhatAModelMayNotAnswer) {
    const Outcome nothing = asked({paper("fig3"), "--plugin-dir", TEST_PLUGIN_FOLDER, "--model", "odd_column,answer=nothing"});
    EXPECT_EQ(nothing.code, 2);
    EXPECT_EQ(nothing.err, "--model odd_column,answer=nothing: needle.buckling: answered no number for 0.1 m of needle in air\n");
    const Outcome thrown = asked({paper("fig3"), "--plugin-dir", TEST_PLUGIN_FOLDER, "--model", "odd_column,answer=throw"});
    EXPECT_EQ(thrown.code, 2);
    EXPECT_EQ(thrown.err, "--model odd_column,answer=throw: needle.buckling: the plugin 'odd_column' failed: it snapped\n");
}

TEST(CriticalLoadRefuses, FilesThatCannotBeWrittenAndAMissingGnuplot) {
    const Bench bench;
    EXPECT_EQ(bench.stylet({"critical-load", paper("fig3"), "--json", "nowhere/x.json"}).err,
              "nowhere/x.json: cannot be written: No such file or directory\n");
    EXPECT_EQ(bench.stylet({"critical-load", paper("fig3"), "--csv", "nowhere/x.csv"}).code, 4);
    // Before anything is computed: the scene that is not there is not even looked for; and nothing is left behind.
    EXPECT_EQ(bench.stylet({"critical-load", "nowhere.yaml", "--csv", "x.csv", "--json", "nowhere/x.json"}).code, 4);
    EXPECT_FALSE(bench.has("x.csv"));
    const Outcome plot = bench.stylet_with_path(bench.path("").string(), {"critical-load", paper("fig10a_l200"), "--plot", "x"});
    EXPECT_EQ(plot.code, 4);
    EXPECT_THAT(plot.err, HasSubstr("found no gnuplot on the PATH"));
}

}    // namespace
}    // namespace stylet::commands
