#include "checks.h"

#include <stylet/contract/allocations.h>

#include <array>
#include <cmath>

namespace stylet::contract {
namespace {

constexpr std::array all_ends{Ends::clamped_free, Ends::pinned_pinned, Ends::clamped_pinned,
                              Ends::clamped_clamped};    // weakest first

Column column_of(const Case& with, Ends ends) {
    return {.bending_stiffness = with.needle.bending_stiffness(),
            .free_length = with.needle.length,
            .radius = with.needle.radius,
            .ends = ends};
}

/// Runs a check on the model with the case's needle held in every way.
template <class Function>
void for_all_ends(const Descriptor& plugin, const Case& with, Function check) {
    const auto object = make(plugin, with);
    for (const Ends ends : all_ends) {
        SCOPED_TRACE("ends " + std::to_string(static_cast<int>(ends)));
        check(static_cast<const BucklingModel&>(*object), column_of(with, ends));
    }
}

void any_length_has_a_finite_load(const Descriptor& plugin, const Case& with) {
    for_all_ends(plugin, with, [](const BucklingModel& model, Column column) {
        for (const double length : {0.0, 1e-300, 1e-12, 1e-6, column.radius, 1e-3, 0.1, 1.0, 1e3}) {
            column.free_length = length;
            const double load = model.critical_load(column);
            EXPECT_TRUE(std::isfinite(load) && load > 0.0) << load << " N at " << length << " m";
        }
    });
}

void a_longer_column_bears_less(const Descriptor& plugin, const Case& with) {
    for_all_ends(plugin, with, [](const BucklingModel& model, Column column) {
        const double longest = column.free_length;
        double before = model.critical_load(column);
        for (int i = 19; i >= 1; --i) {
            column.free_length = longest * i / 20.0;
            const double now = model.critical_load(column);
            EXPECT_GT(now, before) << "at " << column.free_length << " m";
            before = now;
        }
    });
}

void a_stiffer_column_bears_more(const Descriptor& plugin, const Case& with) {
    for_all_ends(plugin, with, [](const BucklingModel& model, Column column) {
        const double before = model.critical_load(column);
        column.bending_stiffness *= 1.01;
        EXPECT_GT(model.critical_load(column), before);
    });
}

void a_tighter_hold_bears_no_less(const Descriptor& plugin, const Case& with) {
    double before = 0.0;
    for_all_ends(plugin, with, [&before](const BucklingModel& model, const Column& column) {
        EXPECT_GE(model.critical_load(column), before);
        before = model.critical_load(column);
    });
}

void same_column_same_load(const Descriptor& plugin, const Case& with) {
    for_all_ends(plugin, with, [&](const BucklingModel& model, Column column) {
        const auto other = make(plugin, with);
        const double first = model.critical_load(column);
        Column disturbing = column;
        disturbing.free_length *= 0.5;
        (void)model.critical_load(disturbing);
        EXPECT_EQ(model.critical_load(column), first);
        EXPECT_EQ(static_cast<const BucklingModel&>(*other).critical_load(column), first);
    });
}

void asking_allocates_nothing(const Descriptor& plugin, const Case& with) {
    for_all_ends(plugin, with, [](const BucklingModel& model, const Column& column) {
        const std::size_t before = allocations();
        (void)model.critical_load(column);
        EXPECT_EQ(allocations() - before, 0U);
    });
}

}    // namespace

std::vector<Check> buckling_checks() {
    return {{"AnyLengthHasAFiniteLoad", any_length_has_a_finite_load},
            {"ALongerColumnBearsLess", a_longer_column_bears_less},
            {"AStifferColumnBearsMore", a_stiffer_column_bears_more},
            {"ATighterHoldBearsNoLess", a_tighter_hold_bears_no_less},
            {"SameColumnSameLoad", same_column_same_load},
            {"AskingAllocatesNothing", asking_allocates_nothing}};
}

}    // namespace stylet::contract
