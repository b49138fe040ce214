#pragma once

#include <stylet/force_model.h>
#include <stylet/needle_model.h>
#include <stylet/tissue_model.h>

#include "core/contacts/contact_set.h"
#include "core/contacts/track.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace stylet::core {

/// Where the tip is.
enum class TipState : std::uint8_t { free, touching, inside };

/// What a committed step did to the contacts.
struct ContactChange {
    const char* event = nullptr;    // touched, punctured, withdrawn, …; text that lives for ever
    bool punctured = false;
    double cut = 0.0;       // [m] new track
    int layer = outside;    // in which it was cut
};

using Effects = std::span<const std::unique_ptr<ForceModel>>;

/// Knows where needle and tissue touch: the tip, and one shaft contact for each piece of track behind it.
///
/// `arrange` finds the contacts of a step and their laws and changes nothing; `absorb` takes a committed step. The tip cuts a
/// track; each piece of it, once begun, is a contact at fixed material points whose needle arclength shrinks as the needle slips
/// forward. Coverage grows from zero, so a new contact makes no jump. In its own old track the tip is free until the end of it.
class Contacts {
public:
    Contacts(double needle_length, double needle_radius, double spacing);

    /// Of a needle alone in air, whose tip is its only contact: held sideways where its `ends` say so, and free along the needle
    /// unless an effect holds it.
    explicit Contacts(const NeedleSetup& needle);

    /// Notes where the needle's material points are now; called before predict.
    void remember(const NeedleModel& needle);

    /// Fills `set` for a step, with the bodies as predicted.
    /// `time` [s] is that at the end of the step.
    void arrange(const NeedleModel& needle, const TissueModel& tissue, Effects effects, double time, ContactSet& set) const;

    ContactChange absorb(const NeedleModel& needle, const TissueModel& tissue, const ContactSet& set);

    [[nodiscard]] TipState tip() const { return tip_; }
    [[nodiscard]] double inserted() const {
        return tip_ == TipState::inside ? std::max(0.0, way_) : 0.0;
    }                                                                       // [m] of the tip along its track
    [[nodiscard]] double free_length() const;                               // [m]
    [[nodiscard]] double free_length_after(const ContactSet& set) const;    // [m] once `set` is absorbed
    [[nodiscard]] int shaft_contacts() const { return static_cast<int>(shaft_.size()); }
    [[nodiscard]] Mouth mouth() const;

private:
    /// A piece of shaft in a piece of track (or the tip), as the last commit left it.
    struct ShaftContact {
        double arclength;                          // [m] of the needle at the track's node
        Vector3 force = Vector3::Zero();           // [N] on the needle, all of it
        Vector3 effect_force = Vector3::Zero();    // [N] of that, what the coupling and the effects exert
        Vector3 sideways = Vector3::Zero();        // [N] of all of it, what was across the needle
        double configurational = 0.0;              // [N] and the rest, along −axis
        bool held = false;                         // sideways on its track
        Vector3 beside = Vector3::Zero();          // [m] how far beside it
        double excess = 0.0;                       // [N] see ContactRow
        double axial_force = 0.0;                  // [N]
        double slip = 0.0;                         // [m] in the last step
        bool slipping = false;
        Vector3 position = Vector3::Zero();    // [m] world, before predict

        void take(const ContactRow& row);
        void recall(ContactRow& row) const;
    };

    [[nodiscard]] double free_length_with(double past_mouth) const;
    [[nodiscard]] bool finds_own_track(const Vector3& touched) const;
    ContactRow tip_row(TipState tip, const ContactPoint& point, const NeedleModel& needle, const TissueModel& tissue,
                       Effects effects, double time) const;
    void add_tip_in_air(const NeedleModel& needle, Effects effects, double time, ContactSet& set) const;
    void add_shaft(int i, const NeedleModel& needle, const TissueModel& tissue, Effects effects, double time,
                   ContactSet& set) const;
    [[nodiscard]] ContactLaw law_of(const Contact& contact, Effects effects) const;

    ContactChange absorb_inside(const NeedleModel& needle, const TissueModel& tissue, const ContactSet& set);
    void lay_shaft();
    void let_go();
    void withdraw();

    double length_;                   // [m] of the needle
    double radius_;                   // [m]
    std::optional<Ends> in_air_;      // of a needle that is alone
    std::optional<Vector3> stand_;    // [m] what the tip of one leans against, unloaded, at the last commit
    TipState tip_ = TipState::free;
    Track track_;
    Vector3 touch_ = Vector3::Zero();           // [m] material point that the tip rests on
    double way_ = 0.0;                          // [m] of the tip along the track
    bool letting_go_ = false;                   // out again; the next step carries nothing, so that the books see what was lost
    bool outside_ = false;                      // the tip has left the tissue's extent
    Vector3 tip_position_ = Vector3::Zero();    // [m] world, at the last commit
    bool tip_known_ = false;
    ShaftContact tip_contact_{.arclength = 0.0};    // what the tip's row carried
    std::vector<ShaftContact> shaft_;
};

}    // namespace stylet::core
