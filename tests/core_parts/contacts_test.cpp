#include "core/contacts/contacts.h"

#include <stylet/error.h>

#include <gtest/gtest.h>

#include "still_bodies.h"

#include <string>

namespace stylet::core {
namespace {

constexpr double length = 0.2, radius = 0.3e-3, spacing = 0.005;    // [m]
constexpr double interface = 0.012, bottom = 0.04;                  // [m]
constexpr double rupture = 1.0, cutting = 0.3;                      // [N]
constexpr double friction = 5.0;                                    // [N/m]
constexpr double millimetre = 1e-3;
constexpr double rounding = 1e-12;    // [m] and [N] of sums of some dozen steps

class Limits final : public ForceModel {
public:
    void add_to(const Contact& contact, ContactLaw& law) const override {
        if (contact.tip) {
            law.add_tip(contact.inside ? cutting : rupture);
        } else {
            law.add_axial(friction * contact.coverage);
        }
    }
};

/// A needle that goes straight down into tissue that does not give: whatever the hand does is an advance past the tissue.
class Insertion : public testing::Test {
protected:
    Insertion() {
        effects_.push_back(std::make_unique<Limits>());
        needle_.put_tip(tip_);
    }

    /// Finds the contacts with the tip moved by this much.
    void move(double down, double aside = 0.0) {
        contacts_.remember(needle_);
        tip_ += Vector3(aside, 0.0, -down);
        needle_.put_tip(tip_);
        contacts_.arrange(needle_, tissue_, effects_, 0.0, set_);
    }
    /// The step's answer: the tip carries this and advances by that, the shaft with it.
    ContactChange answer(double tip_force, double advance) {
        for (ContactRow& row : set_.rows) {
            row.axial_force = row.upper;
            row.advance = advance;
        }
        if (!set_.empty()) set_.rows.front().axial_force = tip_force;
        return contacts_.absorb(needle_, tissue_, set_);
    }
    /// Touches the surface, and punctures it with the next step.
    ContactChange puncture(double advance) {
        move(tip_.z());
        (void)answer(0.5 * rupture, 0.0);
        move(advance);
        return answer(rupture, advance);
    }
    ContactChange go(double advance) {
        move(advance);
        return answer(advance > 0.0 ? cutting : 0.0, advance);
    }
    static std::string event(const ContactChange& change) { return change.event == nullptr ? "" : change.event; }

    Vector3 tip_{0.0, 0.0, 2.0 * millimetre};
    StraightNeedle needle_{length};
    StillTissue tissue_{interface, bottom};
    std::vector<std::unique_ptr<ForceModel>> effects_;
    Contacts contacts_{length, radius, spacing};
    ContactSet set_;
};

TEST_F(Insertion, HasNoContactAboveTheSurface) {
    move(millimetre);
    EXPECT_TRUE(set_.empty());
    EXPECT_EQ(event(answer(0.0, 0.0)), "");
    EXPECT_EQ(contacts_.tip(), TipState::free);
    EXPECT_EQ(contacts_.free_length(), length);
    EXPECT_EQ(contacts_.mouth().row, -1);
}

TEST_F(Insertion, TouchesWhereItsTipCrossesTheSurface) {
    move(4.0 * millimetre, 8.0 * millimetre);    // from 2 mm above to 2 mm below, sideways on the way
    ASSERT_EQ(set_.points.size(), 1u);
    EXPECT_LE((set_.points[0].material - Vector3(4.0 * millimetre, 0.0, 0.0)).norm(), rounding);
    EXPECT_TRUE(set_.points[0].tip);
    EXPECT_EQ(set_.points[0].arclength, length);
    const ContactRow& row = set_.rows[0];
    EXPECT_TRUE(row.lateral);
    EXPECT_EQ(row.lower, 0.0);
    EXPECT_EQ(row.upper, rupture);
    EXPECT_EQ(row.gap, 0.0);
    EXPECT_EQ(event(answer(0.2, 0.0)), "touched");
    EXPECT_EQ(contacts_.tip(), TipState::touching);
    EXPECT_EQ(contacts_.free_length(), length);
}

TEST_F(Insertion, ArrangesTheSameContactsAgainUntilTheStepIsAbsorbed) {
    move(4.0 * millimetre);
    const Vector3 material = set_.points[0].material;
    contacts_.arrange(needle_, tissue_, effects_, 0.0, set_);
    ASSERT_EQ(set_.points.size(), 1u);
    EXPECT_EQ(set_.points[0].material, material);
    EXPECT_EQ(contacts_.tip(), TipState::free);
}

TEST_F(Insertion, HasAFrameOfItsAxisThatTurnsRight) {
    move(4.0 * millimetre);
    const Matrix3& frame = set_.rows[0].frame;
    EXPECT_LE((frame.col(2) - Vector3::UnitZ()).norm(), rounding);
    EXPECT_LE((frame.transpose() * frame - Matrix3::Identity()).norm(), rounding);
    EXPECT_NEAR(frame.determinant(), 1.0, rounding);
}

TEST_F(Insertion, LiftsOffWhenTheTipPullsNoMore) {
    move(2.0 * millimetre);
    (void)answer(0.2, 0.0);
    move(-millimetre);
    EXPECT_EQ(event(answer(0.0, -millimetre)), "lifted off");
    EXPECT_EQ(contacts_.tip(), TipState::free);
}

TEST_F(Insertion, StaysOutsideBelowItsRupture) {
    move(2.0 * millimetre);
    (void)answer(0.2, 0.0);
    move(millimetre);
    EXPECT_EQ(event(answer(0.999 * rupture, 0.0)), "");
    EXPECT_EQ(contacts_.tip(), TipState::touching);
    EXPECT_EQ(contacts_.inserted(), 0.0);
}

TEST_F(Insertion, PuncturesAtItsRupture) {
    const ContactChange change = puncture(millimetre);
    EXPECT_EQ(event(change), "punctured");
    EXPECT_TRUE(change.punctured);
    EXPECT_NEAR(change.cut, millimetre, rounding);
    EXPECT_EQ(change.layer, 0);
    EXPECT_EQ(contacts_.tip(), TipState::inside);
    EXPECT_NEAR(contacts_.inserted(), millimetre, rounding);
    EXPECT_EQ(contacts_.mouth().row, 1);
}

TEST_F(Insertion, GainsAShaftContactEachSpacingThatBeginsWithNothing) {
    (void)puncture(millimetre);
    double last = 0.0;
    for (int step = 2; step <= 23; ++step) {
        move(millimetre);
        double whole = 0.0;
        for (std::size_t i = 1; i < set_.rows.size(); ++i) {
            EXPECT_EQ(set_.rows[i].lower, -set_.rows[i].upper);
            EXPECT_EQ(set_.rows[i].lateral, set_.points[i].span.norm() > radius);
            whole += set_.rows[i].upper;
        }
        EXPECT_NEAR(whole, friction * (step - 1) * millimetre, rounding) << "step " << step;    // no jump as contacts come
        EXPECT_NEAR(whole - last, friction * millimetre, rounding) << "step " << step;
        EXPECT_EQ(set_.rows[0].upper, cutting);
        last = whole;
        (void)answer(cutting, millimetre);
        EXPECT_EQ(contacts_.shaft_contacts(), 1 + static_cast<int>(step * millimetre / spacing + rounding));
        EXPECT_NEAR(contacts_.free_length(), length - step * millimetre + radius,
                    rounding);    // it ends a radius inside the track
        EXPECT_NEAR(contacts_.inserted(), step * millimetre, rounding);
    }
}

TEST_F(Insertion, KeepsContactsAtMaterialPointsWhoseArclengthShrinks) {
    (void)puncture(12.0 * millimetre);
    move(0.0);
    const std::vector<ContactPoint> before = set_.points;
    (void)answer(cutting, 0.0);
    (void)go(2.0 * millimetre);
    move(0.0);
    ASSERT_EQ(set_.points.size(), before.size());
    for (std::size_t i = 1; i < before.size(); ++i) {
        EXPECT_EQ(set_.points[i].material, before[i].material);
        EXPECT_NEAR(set_.points[i].arclength, before[i].arclength - 2.0 * millimetre, rounding);
    }
    EXPECT_EQ(set_.points[0].arclength, length);
}

TEST_F(Insertion, SaysInWhichLayerItCuts) {
    (void)puncture(millimetre);
    EXPECT_EQ(go(10.0 * millimetre).layer, 0);
    (void)go(2.0 * millimetre);    // across the interface at 12 mm
    EXPECT_EQ(go(millimetre).layer, 1);
}

TEST_F(Insertion, LosesItsContactsAsItIsWithdrawn) {
    (void)puncture(17.0 * millimetre);
    EXPECT_EQ(contacts_.shaft_contacts(), 4);
    EXPECT_EQ(event(go(-8.0 * millimetre)), "crossed an interface");
    EXPECT_EQ(contacts_.shaft_contacts(), 2);
    EXPECT_NEAR(contacts_.free_length(), length - 9.0 * millimetre + radius, rounding);
    EXPECT_EQ(event(go(-10.0 * millimetre)), "withdrawn");
    EXPECT_EQ(contacts_.tip(), TipState::free);
    EXPECT_EQ(contacts_.shaft_contacts(), 0);
    EXPECT_EQ(contacts_.free_length(), length);
    EXPECT_EQ(contacts_.inserted(), 0.0);
}

TEST_F(Insertion, FindsItsOwnTrackAgainAndCutsNothingTwice) {
    (void)puncture(10.0 * millimetre);
    (void)go(-12.0 * millimetre);
    move(5.0 * millimetre, 0.9 * radius);    // from 2 mm above the surface to 3 mm below
    ASSERT_EQ(set_.rows[0].upper, cutting);
    EXPECT_NEAR(set_.rows[0].gap, 10.0 * millimetre, rounding);    // free until the end of its track
    const ContactChange back = answer(0.0, 3.0 * millimetre);
    EXPECT_EQ(event(back), "back in its track");
    EXPECT_FALSE(back.punctured);
    EXPECT_EQ(back.cut, 0.0);
    EXPECT_EQ(go(6.0 * millimetre).cut, 0.0);
    EXPECT_NEAR(go(4.0 * millimetre).cut, 3.0 * millimetre, rounding);
    EXPECT_NEAR(contacts_.inserted(), 13.0 * millimetre, rounding);
}

TEST_F(Insertion, BesideItsOwnTrackMustPunctureAnew) {
    (void)puncture(10.0 * millimetre);
    (void)go(-12.0 * millimetre);
    move(5.0 * millimetre, 5.0 * radius);
    EXPECT_EQ(set_.rows[0].upper, rupture);
    EXPECT_EQ(event(answer(0.3, 0.0)), "touched");
    move(millimetre);
    const ContactChange change = answer(rupture, millimetre);
    EXPECT_TRUE(change.punctured);
    EXPECT_NEAR(change.cut, millimetre, rounding);
}

TEST_F(Insertion, LeavesTheTissueAtItsBottom) {
    (void)puncture(38.0 * millimetre);
    const ContactChange change = go(4.0 * millimetre);
    EXPECT_EQ(event(change), "left the tissue");
    move(millimetre);
    EXPECT_FALSE(set_.rows[0].lateral);
    EXPECT_EQ(set_.rows[0].upper, 0.0);
    EXPECT_EQ(event(answer(0.0, millimetre)), "");    // once
}

TEST(Contacts, ThatWouldBeTooManyAreAnErrorAtTheirSpacing) {
    EXPECT_NO_THROW(Contacts(length, radius, length / 127.0));
    try {
        const Contacts contacts(length, radius, 1e-3);
        FAIL() << "took 200 contacts";
    } catch (const Error& error) {
        EXPECT_EQ(error.key(), "coupling.contact_spacing");
        EXPECT_EQ(std::string(error.what()),
                  "the needle has room for more than 127 contacts at this spacing, wanted a spacing of at least its length over "
                  "that");
    }
}

}    // namespace
}    // namespace stylet::core
