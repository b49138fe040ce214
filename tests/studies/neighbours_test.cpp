// The scenes beside a scene: which models, which steps, which effects left out.
#include "apps/study/neighbours.h"
#include "apps/study/fineness.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace stylet::study {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

const core::PluginFolders folders = core::PluginFolders::standard();

ChangedScene scene_file(const std::string& name, const std::vector<core::Override>& changes = {}) {
    return {std::filesystem::path(SCENE_FOLDER) / name, changes, folders};
}

std::vector<std::string> names_of(const std::vector<Neighbour>& neighbours) {
    std::vector<std::string> names;
    for (const Neighbour& neighbour : neighbours) names.push_back(neighbour.name);
    return names;
}

/// "needle.type=rod, run.rate=2 kHz, without effects[0]"
std::string text_of(const std::vector<core::Override>& changes) {
    std::string text;
    for (const core::Override& change : changes) {
        text += text.empty() ? "" : ", ";
        text += change.removes ? "without " + change.key : change.key + "=" + change.value;
    }
    return text;
}

TEST(Neighbours, OfThePapersNeedleAreEveryCombinationOfItsModels) {
    const Neighbours neighbours = neighbours_of(scene_file("paper/fig10a_l150.yaml"));
    EXPECT_THAT(names_of(neighbours.models),
                ElementsAre("half_space, beam_column, euler", "half_space, rod", "half_space, elastica, euler",
                            "half_space, rigid", "corotational_fem, beam_column, euler", "corotational_fem, rod",
                            "corotational_fem, elastica, euler", "corotational_fem, rigid"));
    EXPECT_EQ(text_of(neighbours.models.front().changes), "") << "the scene itself";
    EXPECT_EQ(text_of(neighbours.models[5].changes), "tissue.type=corotational_fem, needle.type=rod");
    EXPECT_THAT(names_of(neighbours.steps), ElementsAre("run.rate=500 Hz", "run.rate=2 kHz", "coupling.contact_spacing=10 mm",
                                                        "coupling.contact_spacing=2.5 mm"));
}

TEST(Neighbours, ThatRefuseTheSceneAreLeftOutAndSaidWhy) {
    const Neighbours neighbours = neighbours_of(scene_file("paper/fig10a_l150.yaml"));
    ASSERT_THAT(neighbours.left_out, SizeIs(1));
    EXPECT_EQ(neighbours.left_out[0].name, "winkler");
    EXPECT_THAT(neighbours.left_out[0].why, StartsWith("needle.buckling.winkler.foundation_modulus: found none"));
}

TEST(Neighbours, StepTheResolutionOfTheModelsThatAreChosen) {
    const Neighbours neighbours = neighbours_of(scene_file("paper/fig10a_l150.yaml", {{"needle.type", "rod"}}));
    EXPECT_EQ(neighbours.models.front().name, "half_space, rod");
    EXPECT_THAT(names_of(neighbours.steps),
                ElementsAre("needle.rod.nodes=21", "needle.rod.nodes=81", "run.rate=500 Hz", "run.rate=2 kHz",
                            "coupling.contact_spacing=10 mm", "coupling.contact_spacing=2.5 mm"));
}

TEST(Neighbours, OfATissueAloneHaveNeitherNeedleNorContacts) {
    const Neighbours neighbours = neighbours_of(scene_file("validation/block_m0.yaml"));
    EXPECT_THAT(names_of(neighbours.models), ElementsAre("corotational_fem", "half_space"));
    EXPECT_THAT(names_of(neighbours.steps),
                ElementsAre("tissue.corotational_fem.cells=[4, 4, 3]", "tissue.corotational_fem.cells=[9, 9, 8]",
                            "tissue.corotational_fem.pressure=patch", "tissue.corotational_fem.solver=newton",
                            "tissue.corotational_fem.accuracy=0.002", "tissue.corotational_fem.accuracy=0.0005",
                            "run.rate=500 Hz", "run.rate=2 kHz"));
}

TEST(Neighbours, OfAWrongSceneAreItsErrors) {
    EXPECT_THROW((void)neighbours_of(scene_file("paper/fig9.yaml", {{"needle.radius", "-1 mm"}})), core::SceneErrors);
}

TEST(Neighbours, KnowWhichNeedlesAskForACriticalLoad) {
    const auto asks = [](const char* needle) {
        return asks_for_load(scene_file("paper/fig9.yaml", {{"needle.type", needle}}).read(), folders);
    };
    EXPECT_TRUE(asks("beam_column"));
    EXPECT_TRUE(asks("elastica"));
    EXPECT_FALSE(asks("rod"));
    EXPECT_FALSE(asks("rigid"));
    EXPECT_FALSE(asks_for_load(scene_file("validation/block_m0.yaml").read(), folders));
}

TEST(FinestStep, TakesEveryNumberButTheRateOneStepFinerAtOnce) {
    const core::Scene scene = scene_file("paper/fig9.yaml", {{"tissue.type", "corotational_fem"}, {"needle.type", "rod"}}).read();
    EXPECT_EQ(text_of(finest_step(scene, folders)),
              "tissue.corotational_fem.cells=[24, 24, 9], tissue.corotational_fem.accuracy=0.0005, needle.rod.nodes=81, "
              "coupling.contact_spacing=2.5 mm");
}

TEST(LoadByMesh, IsToBeMindedOfALoadedTissueAloneUntilItsAreaSharesTheLoad) {
    const auto mind = [](const char* scene, const std::vector<core::Override>& changes) {
        return load_by_mesh(scene_file(scene, changes).read(), folders);
    };
    const auto by_nodes = mind("validation/block_m0.yaml", {});
    ASSERT_TRUE(by_nodes.has_value());
    EXPECT_THAT(*by_nodes, HasSubstr("--set tissue.corotational_fem.load_shared_by=area"));
    EXPECT_EQ(mind("validation/block_m0.yaml", {{"tissue.corotational_fem.load_shared_by", "area"}}), std::nullopt);
    EXPECT_EQ(mind("validation/half_space_patch.yaml", {}), std::nullopt) << "it has no mesh";
    EXPECT_EQ(mind("paper/fig9.yaml", {{"tissue.type", "corotational_fem"}}), std::nullopt) << "it bears a needle";
}

TEST(Omissions, AreEffectsBucklingAndWhatAQuantitySwitchesOff) {
    EXPECT_THAT(names_of(omissions(scene_file("paper/fig9.yaml").read(), folders)),
                ElementsAre("effects[0] fracture", "effects[1] friction", "effects[2] friction", "needle.buckling euler"));
    const std::vector<Neighbour> of_block = omissions(scene_file("validation/block_m0.yaml").read(), folders);
    EXPECT_THAT(names_of(of_block), ElementsAre("effects[0] patch_load", "tissue.corotational_fem.gravity"));
    EXPECT_EQ(text_of(of_block[1].changes), "without tissue.corotational_fem.gravity");
    const core::Scene rod = scene_file("validation/limit_load.yaml").read();
    EXPECT_THAT(names_of(omissions(rod, folders)), ElementsAre("effects[0] pin", "needle.rod.damping_time"));
}

TEST(Omissions, LeaveSoundScenes) {
    const ChangedScene fig9 = scene_file("paper/fig9.yaml");
    for (const Neighbour& omission : omissions(fig9.read(), folders)) EXPECT_NO_THROW((void)fig9.read(omission.changes));
}

/// The parameter's next value, or "none".
std::string stepped(Parameter parameter, Parameters::Value value, Step step) {
    Parameters given;
    given.set(parameter.name, std::move(value));
    return one_step(parameter, given, step).value_or("none");
}

TEST(OneStep, HalvesAndDoublesGapsBetweenAnOddCountOfPoints) {
    const Parameter nodes = finer_above(integer("nodes", {.least = 5, .greatest = 1001}, "nodes"));
    EXPECT_EQ(stepped(nodes, std::int64_t{41}, Step::finer), "81");
    EXPECT_EQ(stepped(nodes, std::int64_t{41}, Step::coarser), "21");
    EXPECT_EQ(stepped(nodes, std::int64_t{64}, Step::finer), "128");
    EXPECT_EQ(stepped(nodes, std::int64_t{7}, Step::coarser), "5") << "the end of its range";
    EXPECT_EQ(stepped(nodes, std::int64_t{5}, Step::coarser), "none");
    EXPECT_EQ(stepped(nodes, std::int64_t{1001}, Step::finer), "none");
}

TEST(OneStep, ScalesNumbersAndVectorsWithTheirUnits) {
    const Parameter spacing = finer_below(number("spacing", "m", positive, "length"));
    EXPECT_EQ(stepped(spacing, 0.005, Step::finer), "2.5 mm");
    EXPECT_EQ(stepped(spacing, 0.005, Step::coarser), "10 mm");
    const Parameter density =
        finer_above(number("density", "kg/m^3", {.least = 0.0, .greatest = 1000.0, .open_above = true}, ""));
    EXPECT_EQ(stepped(density, 400.0, Step::finer), "800 kg/m^3");
    EXPECT_EQ(stepped(density, 800.0, Step::finer), "none") << "no number is the last below 1000";
    const Parameter cells = finer_above(vector3("cells", "1", "cells"));
    EXPECT_EQ(stepped(cells, Vector3(16, 16, 6), Step::finer), "[24, 24, 9]");
    EXPECT_EQ(stepped(cells, Vector3(2, 1, 1), Step::coarser), "[1, 1, 1]");
    EXPECT_EQ(stepped(cells, Vector3(1, 1, 1), Step::coarser), "none");
    const Parameter size = finer_below(vector3("size", "m", "size"));
    EXPECT_EQ(stepped(size, Vector3(0.3, 0.03, 0.003), Step::finer), "[200 mm, 20 mm, 2 mm]");
}

TEST(OneStep, TakesTheNextWordTheWayThatIsFiner) {
    const Parameter solver = finer_below(choice("solver", "newton hybrid quasi_newton", "solver"));
    EXPECT_EQ(stepped(solver, std::string("quasi_newton"), Step::finer), "hybrid");
    EXPECT_EQ(stepped(solver, std::string("newton"), Step::coarser), "hybrid");
    EXPECT_EQ(stepped(solver, std::string("newton"), Step::finer), "none");
}

TEST(Written, TakesThePrefixThatPeopleWouldAndReadsBack) {
    EXPECT_EQ(written(0.0025, "m"), "2.5 mm");
    EXPECT_EQ(written(0.001, "s"), "1 ms");
    EXPECT_EQ(written(3600.0, "s"), "3600 s");
    EXPECT_EQ(written(25e3, "Pa"), "25 kPa");
    EXPECT_EQ(written(1e-7, "m"), "1e-07 m");
    EXPECT_EQ(written(7850.0, "kg/m^3"), "7850 kg/m^3");
    EXPECT_EQ(written(0.0005, "1"), "0.0005");
}

TEST(OneStep, IsNoneWhereNoWayIsFinerOrNothingIsGiven) {
    EXPECT_EQ(stepped(number("length", "m", positive, "length"), 0.1, Step::finer), "none");
    const Parameter nodes = finer_above(integer("nodes", any, "nodes"));
    EXPECT_EQ(one_step(nodes, Parameters{}, Step::finer), std::nullopt);
}

}    // namespace
}    // namespace stylet::study
