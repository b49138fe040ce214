// The contract holds for plain plugins that keep it, and each of its checks fails for one that breaks it in just that way.
#include "flawed_plugins.h"

#include <gtest/gtest-spi.h>

#include <algorithm>

namespace stylet::contract {
namespace {

/// The names of the checks that a plugin with this flaw does not pass.
std::vector<std::string> broken_promises(const Descriptor& plugin, const std::string& flaw) {
    const Case with{.parameters = {{"flaw", flaw}}};
    std::vector<std::string> broken;
    for (const Check& check : checks_of(plugin.role)) {
        testing::TestPartResultArray results;
        {
            const testing::ScopedFakeTestPartResultReporter reporter(
                testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
            check.run(plugin, with);
        }
        if (results.size() > 0) broken.emplace_back(check.name);
    }
    return broken;
}

/// A flaw and the check that must notice it; others may as well.
struct Row {
    const char* flaw;
    const char* check;
};

template <class Plugin>
void expect_each_noticed(std::initializer_list<Row> rows) {
    const Descriptor plugin = describe<Plugin>();
    EXPECT_EQ(broken_promises(plugin, "none"), std::vector<std::string>{}) << "a plugin that keeps the contract";
    for (const Row& row : rows) {
        const std::vector<std::string> broken = broken_promises(plugin, row.flaw);
        EXPECT_NE(std::find(broken.begin(), broken.end(), row.check), broken.end()) << row.check << " misses: " << row.flaw;
    }
}

TEST(Contract, NoticesEveryFlawOfATissue) {
    expect_each_noticed<FlawedTissue>({
        {"asymmetric compliance", "ComplianceIsSymmetric"},
        {"compliance 1 % off", "EnergyIsTheWorkOfTheForces"},
        {"moves unannounced", "ContactsMoveAsTheComplianceSays"},
        {"linearise moves the state", "LineariseIsRepeatable"},
        {"rollback forgets the last bit", "RollbackRestoresEveryBit"},
        {"energy of the commit", "EnergyIsThatOfTheLatestTrial"},
        {"differs from its twin", "SameCallsGiveTheSameBits"},
        {"half the energy", "EnergyIsTheWorkOfTheForces"},
        {"damping returns", "LostEnergyNeverComesBack"},
        {"overflows", "ExtremeForcesGiveFiniteAnswers"},
        {"allocates in linearise", "ATickAllocatesNothing"},
        {"allocates with malloc", "ATickAllocatesNothing"},
        {"negative compliance", "ComplianceIsNotNegative"},
        {"sags", "UnloadedPointsRestWhereTheyAre"},
        {"keeps a dent", "UnloadingReturnsToRest"},
        {"creeps at one instant", "StandsStillAtOneInstant"},
        {"interface belongs above", "LocatesItsLayers"},
        {"enters late", "FindsWhereAWayEnters"},
        {"always in doubt", "StartsWithinItsValidity"},
    });
}

TEST(Contract, NoticesEveryFlawOfANeedle) {
    expect_each_noticed<FlawedNeedle>({
        {"rollback forgets the base", "RollbackRestoresEveryBit"},
        {"compliance 1 % off", "ContactsMoveAsTheComplianceSays"},
        {"energy of the commit", "EnergyIsThatOfTheLatestTrial"},
        {"reports the trial", "HandFeelsWhatWasCommitted"},
        {"bends in world x", "MovesRigidlyWithItsBase"},
        {"no moment", "BaseBalancesTheContacts"},
        {"feels half", "BaseBalancesTheContacts"},
        {"position ignores the load", "PlacesAgree"},
        {"tangent not unit", "PlacesAgree"},
        {"starts bent", "UnloadedItIsStraight"},
        {"half the energy", "EnergyComesThroughTheBase"},
        {"no entry force", "EntryForceIsTheEnergyOfFreeLength"},
        {"jumps with the free length", "AFreeLengthToldAtOnceMovesNothing"},
        {"divides by the free length", "AnyFreeLengthGivesFiniteAnswers"},
    });
}

TEST(Contract, NoticesEveryFlawOfABucklingModel) {
    expect_each_noticed<FlawedBuckling>({
        {"not capped", "AnyLengthHasAFiniteLoad"},
        {"divides by the depth", "AnyInsertionHasAFiniteLoad"},
        {"tissue weakens", "TissueNeverWeakens"},
        {"longer is stronger", "ALongerColumnBearsLess"},
        {"stiffness ignored", "AStifferColumnBearsMore"},
        {"ends mixed up", "ATighterHoldBearsNoLess"},
        {"remembers", "SameColumnSameLoad"},
        {"allocates", "AskingAllocatesNothing"},
    });
}

TEST(Contract, NoticesEveryFlawOfAnEffect) {
    expect_each_noticed<FlawedEffect>({
        {"negative limit", "AddsOnlyLimitsThatAreNotNegative"},
        {"infinite limit", "AddsOnlyLimitsThatAreNotNegative"},
        {"multiplies", "OrderDoesNotMatter"},
        {"unlimits the tip", "OrderDoesNotMatter"},
        {"counts its calls", "SameContactSameLaw"},
        {"pays for the square", "AChangeCostsEnergyOnce"},
        {"pays back", "AChangeCostsEnergyOnce"},
        {"pushes along the slip", "DoesNoPositiveWork"},
        {"allocates", "ATickAllocatesNothing"},
    });
}

TEST(Contract, NoticesAFinenessOfWhatHasNoSteps) {
    static constexpr Parameter finer_text[] = {finer_above(text("flaw", "of which no one is finer than another"))};
    Descriptor plugin = describe<FlawedEffect>();
    plugin.parameters = finer_text;
    EXPECT_EQ(broken_promises(plugin, "none"), std::vector<std::string>{"SaysWhatItIs"});
}

TEST(Contract, NoticesEveryFlawOfADevice) {
    expect_each_noticed<FlawedDevice>({
        {"not unit", "ReadingsAreFiniteAndUnit"},
        {"nowhere at the end", "ReadingsAreFiniteAndUnit"},
        {"heard of it tomorrow", "ReadingsAreFiniteAndUnit"},
        {"differs from its twin", "TheSameLifeIsLivedTwice"},
        {"no moment limit", "LimitsArePositive"},
        {"allocates in write", "ATickAllocatesNothing"},
    });
}

TEST(Contract, NoticesAPluginThatDoesNotSayWhatItIs) {
    Descriptor plugin = describe<FlawedDevice>();
    plugin.about.source = "";
    EXPECT_EQ(broken_promises(plugin, "none"), std::vector<std::string>{"SaysWhatItIs"});
    plugin = describe<FlawedDevice>();
    plugin.stamp.alignment *= 2;
    EXPECT_EQ(broken_promises(plugin, "none"), std::vector<std::string>{"SaysWhatItIs"});
    static constexpr Parameter unitless[] = {number("mass", "", positive, "of the handle")};
    plugin = describe<FlawedDevice>();
    plugin.parameters = unitless;
    plugin.parameter_count = 1;
    EXPECT_EQ(broken_promises(plugin, "none"), std::vector<std::string>{"SaysWhatItIs"});
}

TEST(Contract, ALibraryThatIsNotThereIsNamed) {
    try {
        (void)load("no/such/plugin.so");
        FAIL() << "loaded";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("no/such/plugin.so"), std::string::npos) << error.what();
    }
}

}    // namespace
}    // namespace stylet::contract
