// Hard case 28: in and out a thousand times through one track.
#include "tests/whole_scenes/trace.h"

#include <gtest/gtest.h>

#include <cmath>

namespace stylet::whole_scenes {
namespace {

constexpr std::size_t cycles = 1000;
constexpr std::size_t ticks_per_cycle = 200;    // 20 mm in and out at 200 mm/s and 1 kHz
constexpr double most_drift = 1e-6;             // [N] the bound
constexpr double most_uneven = 1e-9;            // relative: the bound on the friction work of a cycle

struct Cycle {
    double friction, fracture;    // [J] in this cycle
};

/// Plays without keeping every sample: two hundred thousand of them.
class CycleWatch {
public:
    void take(const core::Sample& sample, std::size_t tick) {
        const std::size_t cycle = tick / ticks_per_cycle, phase = tick % ticks_per_cycle;
        if (cycle == 1) reference_[phase] = sample.hand_force;
        if (cycle > 1) drift_ = std::max(drift_, std::abs(sample.hand_force - reference_[phase]));
        peak_ = std::max(peak_, std::abs(sample.hand_force));
        ASSERT_TRUE(std::isfinite(sample.hand_force)) << "at tick " << tick;
        if (phase + 1 != ticks_per_cycle) return;
        cycles_.push_back({sample.friction - friction_, sample.fracture - fracture_});
        friction_ = sample.friction;
        fracture_ = sample.fracture;
    }

    [[nodiscard]] double drift() const { return drift_; }    // [N] from the second cycle
    [[nodiscard]] double peak() const { return peak_; }
    [[nodiscard]] const std::vector<Cycle>& all() const { return cycles_; }

private:
    std::array<double, ticks_per_cycle> reference_{};
    double drift_ = 0.0, peak_ = 0.0, friction_ = 0.0, fracture_ = 0.0;
    std::vector<Cycle> cycles_;
};

/// Plays all cycles; returns how often the tip punctured.
std::size_t watch_cycles(Stage& stage, CycleWatch& watch) {
    std::size_t punctures = 0;
    for (std::size_t tick = 0; tick < cycles * ticks_per_cycle; ++tick) {
        stage.simulation().tick();
        watch.take(stage.simulation().sample(), tick);
        for (const core::Event& event : stage.simulation().events()) punctures += event.name == std::string_view("punctured");
    }
    return punctures;
}

void expect_no_drift(const Overrides& overrides) {
    Stage stage(own_scene("stroke"), overrides);
    ASSERT_EQ(stage.ticks(), cycles * ticks_per_cycle);
    CycleWatch watch;
    const std::size_t punctures = watch_cycles(stage, watch);
    const Cycle& second = watch.all()[1];
    double uneven = 0.0, cut_again = 0.0;
    for (std::size_t i = 1; i < cycles; ++i) {
        uneven = std::max(uneven, std::abs(watch.all()[i].friction / second.friction - 1.0));
        cut_again += watch.all()[i].fracture;
    }
    const core::Ledger& ledger = stage.simulation().ledger();
    measured("peak_hand_force", watch.peak(), "N");
    measured("drift", watch.drift(), "N");
    measured("friction_of_a_cycle", second.friction, "J");
    measured("friction_uneven", uneven);
    measured("cut_in_first_cycle", watch.all()[0].fracture, "J");
    measured("cut_in_second_cycle", second.fracture, "J");
    measured("cut_after_first_cycle", cut_again, "J");
    measured("residual", ledger.peak_residual() / ledger.peak_work());
    EXPECT_EQ(punctures, 1u);
    EXPECT_GT(watch.all()[0].fracture, 0.0);
    EXPECT_GT(second.friction, 0.0);
    EXPECT_LE(watch.drift(), most_drift);
    EXPECT_LE(uneven, most_uneven);
    EXPECT_EQ(cut_again, 0.0) << "nothing is cut twice";
    EXPECT_LE(ledger.peak_residual(), sound_residual * ledger.peak_work());
}

TEST(InAndOut, AThousandTimesLeavesARigidNeedleWhereItWas) {
    expect_no_drift({});
}

TEST(InAndOut, AThousandTimesLeavesAFlexibleNeedleWhereItWas) {
    expect_no_drift({{"needle.type", "beam_column"}, {"needle.buckling", "{type: euler}"}});
}

TEST(InAndOut, AThousandTimesLeavesARodWhereItWas) {
    expect_no_drift({{"needle.type", "rod"}});
}

/// A needle that bows at 0.64 N and never gets in: nothing is lost, however often it bows.
TEST(BowedAndStraightened, AThousandTimesLeavesTheNeedleWhereItWas) {
    Stage stage(own_scene("stroke"),
                {{"needle.type", "beam_column"}, {"needle.buckling", "{type: euler}"}, {"needle.length", "200 mm"}});
    CycleWatch watch;
    EXPECT_EQ(watch_cycles(stage, watch), 0u);
    const core::Ledger& ledger = stage.simulation().ledger();
    measured("peak_hand_force", watch.peak(), "N");
    measured("drift", watch.drift(), "N");
    measured("residual", ledger.peak_residual() / ledger.peak_work());
    EXPECT_GT(watch.peak(), 0.65) << "it did not bow";
    EXPECT_LE(watch.drift(), most_drift);
    EXPECT_LE(ledger.peak_residual(), sound_residual * ledger.peak_work());
}

}    // namespace
}    // namespace stylet::whole_scenes
