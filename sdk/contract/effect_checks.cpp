#include "checks.h"

#include <stylet/contract/allocations.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace stylet::contract {
namespace {

constexpr double rounding = 1e-12;    // of the larger value: a few roundings

/// Contacts of every kind: tip and shaft, in and out, in every layer and none, sticking and slipping, none of them large or all
/// of them.
std::vector<Contact> contacts_of(const Case& with) {
    std::vector<Contact> contacts;
    const Vector3 tilted = Vector3(0.2, -0.1, -1.0).normalized();
    for (int layer = -1; layer < static_cast<int>(with.tissue.layers.size()); ++layer) {
        for (const double size : {0.0, 1e-300, 1e-12, 5e-3, 0.2, 1e3}) {
            for (const double sign : {-1.0, 1.0}) {
                for (const bool slipping : {false, true}) {
                    const Contact shaft{.tip = false,
                                        .inside = true,
                                        .layer = layer,
                                        .coverage = size,
                                        .axial_force = sign * size,
                                        .slip = sign * size,
                                        .slipping = slipping,
                                        .needle_radius = with.needle.radius,
                                        .axis = tilted,
                                        .time = 1.0};
                    Contact tip = shaft;
                    tip.tip = true;
                    tip.coverage = 0.0;
                    contacts.push_back(shaft);
                    contacts.push_back(tip);
                    tip.inside = false;
                    contacts.push_back(tip);
                }
            }
        }
    }
    return contacts;
}

ContactLaw law_of(const ForceModel& effect, const Contact& contact, ContactLaw law = {}) {
    effect.add_to(contact, law);
    return law;
}

bool same_law(const ContactLaw& a, const ContactLaw& b) {
    return a.axial_limit == b.axial_limit && a.tip_limit == b.tip_limit && a.tip_limited == b.tip_limited &&
           a.own_force == b.own_force && a.held == b.held;
}

template <class Function>
void for_each_contact(const Descriptor& plugin, const Case& with, Function check) {
    const auto object = make(plugin, with);
    auto& effect = static_cast<ForceModel&>(*object);
    for (const Contact& contact : contacts_of(with)) {
        SCOPED_TRACE(testing::Message() << (contact.tip ? "tip" : "shaft") << (contact.inside ? " inside" : " outside")
                                        << ", layer " << contact.layer << ", coverage " << contact.coverage << " m, slip "
                                        << contact.slip << " m");
        check(effect, contact);
    }
}

void adds_only_limits_that_are_not_negative(const Descriptor& plugin, const Case& with) {
    for_each_contact(plugin, with, [](const ForceModel& effect, const Contact& contact) {
        const ContactLaw law = law_of(effect, contact);
        EXPECT_TRUE(std::isfinite(law.axial_limit) && law.axial_limit >= 0.0) << law.axial_limit;
        EXPECT_TRUE(std::isfinite(law.tip_limit) && law.tip_limit >= 0.0) << law.tip_limit;
        EXPECT_TRUE(law.own_force.allFinite());
        EXPECT_TRUE(contact.tip || !law.tip_limited) << "limits the tip through a shaft contact";
    });
}

/// What it adds does not depend on what is there already, so any order of effects gives the same law.
void order_does_not_matter(const Descriptor& plugin, const Case& with) {
    const ContactLaw others{.axial_limit = 0.7, .tip_limit = 1.3, .tip_limited = true, .own_force = Vector3(0.1, -0.2, 0.3)};
    for_each_contact(plugin, with, [&others](const ForceModel& effect, const Contact& contact) {
        const ContactLaw alone = law_of(effect, contact);
        const ContactLaw after = law_of(effect, contact, others);
        EXPECT_NEAR(after.axial_limit, others.axial_limit + alone.axial_limit, rounding * after.axial_limit);
        EXPECT_NEAR(after.tip_limit, others.tip_limit + alone.tip_limit, rounding * after.tip_limit);
        EXPECT_LE((after.own_force - others.own_force - alone.own_force).norm(), rounding * (1.0 + alone.own_force.norm()));
        EXPECT_TRUE(after.tip_limited);
    });
}

void same_contact_same_law(const Descriptor& plugin, const Case& with) {
    const auto other = make(plugin, with);
    for_each_contact(plugin, with, [&other](const ForceModel& effect, const Contact& contact) {
        const ContactLaw first = law_of(effect, contact);
        EXPECT_TRUE(same_law(law_of(effect, contact), first));
        EXPECT_TRUE(same_law(law_of(static_cast<const ForceModel&>(*other), contact), first));
    });
}

/// A cut of 5 mm costs the same in one piece as in two.
void a_change_costs_energy_once(const Descriptor& plugin, const Case& with) {
    for (int layer = 0; layer < static_cast<int>(with.tissue.layers.size()); ++layer) {
        const auto settle = [&](std::initializer_list<double> cuts) {
            const auto object = make(plugin, with);
            double energy = 0.0;
            for (const double cut : cuts) {
                const double one = static_cast<ForceModel&>(*object).settle(
                    {.punctured = false, .cut = cut, .layer = layer, .needle_radius = with.needle.radius});
                EXPECT_GE(one, 0.0) << "gives energy back";
                EXPECT_TRUE(std::isfinite(one));
                energy += one;
            }
            return energy;
        };
        const double whole = settle({5e-3});
        EXPECT_NEAR(settle({2e-3, 3e-3}), whole, rounding * whole) << "layer " << layer;
        EXPECT_EQ(settle({0.0}), 0.0) << "layer " << layer;
    }
}

/// A spring drags a contact to and fro, as core does: it sticks below its limit and slips at it. The spring takes up `work`.
struct Slider {
    double place = 0.0;    // [m]
    double drag = 0.0;     // [m] where the spring's other end is
    double work = 0.0;     // [J] that the hand put in so far

    void step(const ForceModel& effect, Contact& contact, double next_drag) {
        constexpr double stiffness = 200.0;    // [N/m]
        const ContactLaw law = law_of(effect, contact);
        const double own = law.own_force.dot(contact.axis);
        const double limit = std::max(0.0, contact.tip ? law.tip_limit : law.axial_limit);
        const double before = stiffness * (drag - place);
        const double held = stiffness * (next_drag - place) + own;    // resisted by the contact while it sticks
        const double resisting = std::clamp(held, contact.tip ? 0.0 : -limit, limit);
        const double slip = contact.tip && !law.tip_limited ? 0.0 : (held - resisting) / stiffness;
        place += slip;
        contact.slip = slip;
        contact.slipping = slip != 0.0;
        contact.axial_force = resisting;
        work += 0.5 * (before + stiffness * (next_drag - place)) * (next_drag - drag);
        drag = next_drag;
    }
};

void does_no_positive_work(const Descriptor& plugin, const Case& with) {
    const auto object = make(plugin, with);
    for (Contact contact : contacts_of(with)) {
        if (contact.coverage > 0.2 || (contact.tip && contact.coverage > 0.0)) continue;
        Slider slider;
        constexpr int steps_per_cycle = 200;
        constexpr double amplitude = 0.02;    // [m]
        for (int i = 1; i <= 3 * steps_per_cycle; ++i) {
            slider.step(static_cast<const ForceModel&>(*object), contact,
                        amplitude * std::sin(2.0 * std::numbers::pi * i / steps_per_cycle));
        }
        constexpr double noise = 1e-12;    // [J] rounding of 600 terms of at most 0.1 mJ
        EXPECT_GE(slider.work, -noise) << (contact.tip ? "tip" : "shaft") << ", layer " << contact.layer
                                       << ": closed cycles gave energy";
    }
}

void a_tick_allocates_nothing(const Descriptor& plugin, const Case& with) {
    const auto object = make(plugin, with);
    auto& effect = static_cast<ForceModel&>(*object);
    const std::vector<Contact> contacts = contacts_of(with);
    const std::size_t before = allocations();
    for (const Contact& contact : contacts) (void)law_of(effect, contact);
    (void)effect.settle({.punctured = true, .cut = 1e-3, .layer = 0, .needle_radius = with.needle.radius});
    EXPECT_EQ(allocations() - before, 0U);
}

}    // namespace

std::vector<Check> effect_checks() {
    return {{"AddsOnlyLimitsThatAreNotNegative", adds_only_limits_that_are_not_negative},
            {"OrderDoesNotMatter", order_does_not_matter},
            {"SameContactSameLaw", same_contact_same_law},
            {"AChangeCostsEnergyOnce", a_change_costs_energy_once},
            {"DoesNoPositiveWork", does_no_positive_work},
            {"ATickAllocatesNothing", a_tick_allocates_nothing}};
}

}    // namespace stylet::contract
