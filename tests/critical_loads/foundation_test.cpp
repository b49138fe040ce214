// What a Foundation makes of a scene's tissue.
#include "layered_column.h"

#include <stylet/foundation.h>

#include <gtest/gtest.h>

namespace stylet {
namespace {

using contract::Case;
using contract::Given;

constexpr Column across{.bending_stiffness = 1.27e-3,
                        .free_length = 0.1,
                        .inserted = 0.06,
                        .depth = 0.06,
                        .radius = 0.3e-3,
                        .ends = Ends::clamped_free};

TissueSetup two_layers(const std::string& fixed = "sides") {
    return {.extent = Vector3(0.01, 0.01, 0.05),
            .fixed = fixed,
            .layers = {{.name = "fat", .youngs_modulus = 5e3, .poisson_ratio = 0.3, .density = 1000.0, .thickness = 0.02},
                       {.name = "muscle", .youngs_modulus = 50e3, .poisson_ratio = 0.3, .density = 1000.0, .thickness = 0.03}}};
}

Parameters::Value moduli(std::initializer_list<std::pair<const char*, double>> values) {
    Parameters::Records records;
    for (const auto& [layer, modulus] : values) records.push_back(Given{{"layer", std::string(layer)}, {"modulus", modulus}});
    return records;
}

FoundationPieces pieces(const Case& scene, const Column& column) {
    const Setup setup{.parameters = scene.parameters,
                      .tissue = scene.has_tissue ? &scene.tissue : nullptr,
                      .needle = &scene.needle,
                      .buckling = nullptr,
                      .dt = scene.dt,
                      .workers = one_thread()};
    return Foundation(setup).under(column);
}

/// The parameter that the scene is refused at, and why.
std::string refusal(const Case& scene) {
    try {
        (void)pieces(scene, across);
    } catch (const Error& error) {
        return error.key() + ": " + error.what();
    }
    return "taken";
}

const Given in_order{{"foundation_modulus", std::string("given")}, {"given", moduli({{"muscle", 40e3}, {"fat", 4e3}})}};

void expect_piece(const FoundationPiece& piece, double begin, double end, double modulus) {
    constexpr double rounding = 1e-15;    // [m]
    EXPECT_NEAR(piece.begin, begin, rounding);
    EXPECT_NEAR(piece.end, end, rounding);
    EXPECT_EQ(piece.modulus, modulus);
}

TEST(Foundation, LiesUnderWhatIsInTissueAndUnderNothingElse) {
    const FoundationPieces found = pieces({.parameters = in_order, .tissue = two_layers()}, across);
    ASSERT_EQ(found.size(), 4U);
    expect_piece(found[0], 0.0, 0.1, 0.0);
    expect_piece(found[1], 0.1, 0.12, 4e3);
    expect_piece(found[2], 0.12, 0.15, 40e3);
    expect_piece(found[3], 0.15, 0.16, 0.0);    // through the bottom
}

TEST(Foundation, EndsWhereTheTipIs) {
    Column column = across;
    column.inserted = column.depth = 0.03;
    const FoundationPieces found = pieces({.parameters = in_order, .tissue = two_layers()}, column);
    ASSERT_EQ(found.size(), 3U);
    expect_piece(found[2], 0.12, 0.13, 40e3);
}

TEST(Foundation, IsLongerUnderASlantingNeedle) {
    Column column = across;
    column.depth = 0.5 * column.inserted;
    const FoundationPieces found = pieces({.parameters = in_order, .tissue = two_layers()}, column);
    ASSERT_EQ(found.size(), 3U);
    expect_piece(found[1], 0.1, 0.14, 4e3);
    expect_piece(found[2], 0.14, 0.16, 40e3);
}

TEST(Foundation, OfANeedleAlongTheSurfaceIsTheFirstLayer) {
    Column column = across;
    column.depth = 0.0;
    const FoundationPieces found = pieces({.parameters = in_order, .tissue = two_layers()}, column);
    ASSERT_EQ(found.size(), 2U);
    expect_piece(found[1], 0.1, 0.16, 4e3);
}

TEST(Foundation, ATipThatJustReachesTheBottomIsNotInAir) {
    TissueSetup thirds = two_layers();
    thirds.layers[0].thickness = 0.1;
    thirds.layers[1].thickness = 0.3 - 0.1;    // the two together are not 0.3, to the last digit
    Column column = across;
    column.inserted = column.depth = 0.1 + 0.2;
    EXPECT_EQ(pieces({.parameters = in_order, .tissue = thirds}, column).size(), 3U);
}

TEST(Foundation, WithoutATissueThereIsAirAndNothingIsNeeded) {
    const FoundationPieces found = pieces({.has_tissue = false}, across);
    ASSERT_EQ(found.size(), 2U);
    expect_piece(found[0], 0.0, 0.1, 0.0);
    expect_piece(found[1], 0.1, 0.16, 0.0);
}

TEST(Foundation, TakesTheModulusThatTheSceneNames) {
    const auto first = [](const char* source) {
        return pieces({.parameters = {{"foundation_modulus", std::string(source)}}, .tissue = two_layers()}, across)[1].modulus;
    };
    const TissueSetup tissue = two_layers();
    EXPECT_EQ(first("vesic"), vesic_modulus(tissue.layers[0], across));
    EXPECT_EQ(first("disc_in_block"), disc_modulus(tissue.layers[0], across.radius, conformal_radius(0.01, 0.01)));
    EXPECT_EQ(first("disc_between_walls"), disc_modulus(tissue.layers[0], across.radius, radius_between_walls(0.005, 0.3)));
}

TEST(Foundation, ATissueNeedsAModulus) {
    EXPECT_EQ(
        refusal({.tissue = two_layers()}),
        "foundation_modulus: found none in a scene with a tissue, wanted vesic, disc_in_block, disc_between_walls or given: what "
        "its layers are to a needle");
}

TEST(Foundation, EveryLayerIsGivenOnce) {
    const auto given = [](std::initializer_list<std::pair<const char*, double>> values) {
        return refusal(
            {.parameters = {{"foundation_modulus", std::string("given")}, {"given", moduli(values)}}, .tissue = two_layers()});
    };
    const std::string wanted = ", wanted every layer once: fat, muscle";
    EXPECT_EQ(given({{"fat", 1.0}, {"muscle", 0.0}}), "taken");
    EXPECT_EQ(given({{"fat", 1.0}}), "given: found no modulus of the layer \"muscle\"" + wanted);
    EXPECT_EQ(given({{"fat", 0.0}, {"fat", 2.0}}), "given: found the layer \"fat\" twice" + wanted);
    EXPECT_EQ(given({{"fat", 1.0}, {"mussel", 2.0}}),
              "given: found the layer \"mussel\", wanted the names of the tissue's layers: fat, muscle");
    EXPECT_EQ(refusal({.parameters = {{"foundation_modulus", std::string("given")}}, .tissue = two_layers()}),
              "given: found none beside `foundation_modulus: given`" + wanted);
}

TEST(Foundation, ADiscNeedsSidesThatHold) {
    const auto refused = [](const char* source, const TissueSetup& tissue) {
        return refusal({.parameters = {{"foundation_modulus", std::string(source)}}, .tissue = tissue});
    };
    EXPECT_EQ(refused("disc_in_block", two_layers("bottom_and_sides")), "taken");
    EXPECT_EQ(
        refused("disc_in_block", two_layers("bottom")),
        "foundation_modulus: found disc_in_block for a block whose sides are free (`fixed: bottom`), which in plane strain hold "
        "nothing; wanted `fixed: sides` or `bottom_and_sides`, or else vesic or given");
    TissueSetup oblong = two_layers();
    oblong.extent.y() = 0.02;
    EXPECT_EQ(refused("disc_in_block", oblong), "taken");
    EXPECT_EQ(refused("disc_between_walls", oblong),
              "foundation_modulus: found disc_between_walls for a block of 0.01 m by 0.02 m, wanted a square one: it was "
              "calculated for "
              "no other");
    TissueSetup swelling = two_layers();
    swelling.layers[1].poisson_ratio = -0.2;
    EXPECT_EQ(refused("disc_between_walls", swelling),
              "foundation_modulus: found disc_between_walls and a Poisson ratio below zero in the layer \"muscle\", wanted zero "
              "or more: "
              "it was calculated for no other");
}

TEST(Foundation, RefusesMoreLayersThanItHolds) {
    TissueSetup tissue = two_layers();
    tissue.layers.resize(max_foundation_layers + 1, tissue.layers[0]);
    EXPECT_EQ(refusal({.parameters = {{"foundation_modulus", std::string("vesic")}}, .tissue = tissue}),
              "foundation_modulus: found a tissue of 33 layers, wanted at most 32");
}

}    // namespace
}    // namespace stylet
