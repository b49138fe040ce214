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

/// The same needle with half of it in the tissue.
Column half_in(Column column) {
    column.free_length *= 0.5;
    column.inserted = column.depth = column.free_length;
    return column;
}

/// Runs a check on the model with the case's needle in air, held in every way.
template <class Function>
void for_all_ends(const Descriptor& plugin, const Case& with, Function check) {
    const auto object = make(plugin, with);
    for (const Ends ends : all_ends) {
        SCOPED_TRACE("ends " + std::to_string(static_cast<int>(ends)));
        check(static_cast<const BucklingModel&>(*object), column_of(with, ends));
    }
}

/// The same with the needle in air and with half of it in the tissue.
template <class Function>
void for_all_columns(const Descriptor& plugin, const Case& with, Function check) {
    for_all_ends(plugin, with, [&check](const BucklingModel& model, const Column& column) {
        check(model, column);
        SCOPED_TRACE("half of it in the tissue");
        check(model, half_in(column));
    });
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

void any_insertion_has_a_finite_load(const Descriptor& plugin, const Case& with) {
    for_all_ends(plugin, with, [](const BucklingModel& model, Column column) {
        for (const double free_length : {0.0, column.free_length}) {
            for (const double inserted : {0.0, 1e-300, 1e-12, 1e-6, column.radius, 1e-3, 0.1, 1.0, 1e3}) {
                for (const double slant : {0.0, 0.5, 1.0}) {
                    column.free_length = free_length;
                    column.inserted = inserted;
                    column.depth = slant * inserted;
                    const double load = model.critical_load(column);
                    EXPECT_TRUE(std::isfinite(load) && load > 0.0) << load << " N with " << free_length << " m in air, "
                                                                   << inserted << " m in, the tip " << column.depth << " m deep";
                }
            }
        }
    });
}

void tissue_never_weakens(const Descriptor& plugin, const Case& with) {
    constexpr double discretisation = 1e-6;    // relative, of a model that shares its elements out anew
    for_all_ends(plugin, with, [](const BucklingModel& model, const Column& in_air) {
        const double load_in_air = model.critical_load(in_air);
        for (int i = 1; i <= 20; ++i) {
            Column column = in_air;
            column.inserted = column.depth = in_air.free_length * i / 20.0;
            column.free_length = in_air.free_length - column.inserted;
            EXPECT_GE(model.critical_load(column), (1.0 - discretisation) * load_in_air) << column.inserted << " m in";
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

// In air: a foundation may be the softer for a stiffer needle (Vesic).
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
    for_all_columns(plugin, with, [&](const BucklingModel& model, Column column) {
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
    for_all_columns(plugin, with, [](const BucklingModel& model, const Column& column) {
        const std::size_t before = allocations();
        (void)model.critical_load(column);
        EXPECT_EQ(allocations() - before, 0U);
    });
}

}    // namespace

std::vector<Check> buckling_checks() {
    return {{"AnyLengthHasAFiniteLoad", any_length_has_a_finite_load},
            {"AnyInsertionHasAFiniteLoad", any_insertion_has_a_finite_load},
            {"TissueNeverWeakens", tissue_never_weakens},
            {"ALongerColumnBearsLess", a_longer_column_bears_less},
            {"AStifferColumnBearsMore", a_stiffer_column_bears_more},
            {"ATighterHoldBearsNoLess", a_tighter_hold_bears_no_less},
            {"SameColumnSameLoad", same_column_same_load},
            {"AskingAllocatesNothing", asking_allocates_nothing}};
}

}    // namespace stylet::contract
