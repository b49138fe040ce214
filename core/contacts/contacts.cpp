#include "core/contacts/contacts.h"

#include <stylet/error.h>

#include <algorithm>
#include <limits>

namespace stylet::core {

namespace {

constexpr int most_shaft_contacts = max_contacts - 1;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Two directions across the needle that turn with it, and −axis.
Matrix3 frame_of(const Vector3& axis) {
    const Vector3 beside = std::abs(axis.x()) < 0.9 ? Vector3::UnitX() : Vector3::UnitY();
    Matrix3 frame;
    frame.col(0) = (beside - beside.dot(axis) * axis).normalized();
    frame.col(2) = -axis;
    frame.col(1) = frame.col(2).cross(frame.col(0));
    return frame;
}

}    // namespace

Contacts::Contacts(double needle_length, double needle_radius, double spacing)
    : length_(needle_length), radius_(needle_radius), track_(spacing, most_shaft_contacts) {
    if (needle_length / spacing > most_shaft_contacts) {
        throw Error("coupling.contact_spacing",
                    "the needle has room for more than " + std::to_string(most_shaft_contacts) +
                        " contacts at this spacing, wanted a spacing of at least its length over that");
    }
    shaft_.reserve(most_shaft_contacts);
}

Contacts::Contacts(const NeedleSetup& needle) : Contacts(needle.length, needle.radius, infinity) {
    in_air_ = needle.ends;
}

// A track takes hold of a needle's direction over the first needle diameter: the free length ends at the tip at first, and from
// there on a needle radius below the mouth. Without that a needle bowed by its rupture force would be thrown out again before it
// is in.
double Contacts::free_length_with(double past_mouth) const {
    const double hold = 2.0 * radius_;
    const double held = past_mouth < hold ? 0.5 * past_mouth * std::max(0.0, past_mouth) / hold : past_mouth - 0.5 * hold;
    return std::clamp(length_ - held, 0.0, length_);
}

double Contacts::free_length() const {
    return shaft_.empty() ? length_ : free_length_with(length_ - shaft_.front().arclength);
}

double Contacts::free_length_after(const ContactSet& set) const {
    if (shaft_.empty()) return length_;
    return free_length_with(length_ - shaft_.front().arclength + set.rows[mouth().row].advance);
}

Mouth Contacts::mouth() const {
    if (tip_ != TipState::inside || shaft_.empty()) return {};
    return {.row = 1, .grip = std::clamp((length_ - shaft_.front().arclength) / (2.0 * radius_), 0.0, 1.0)};
}

void Contacts::remember(const NeedleModel& needle) {
    tip_position_ = needle.held_position(length_);
    tip_known_ = true;
    for (ShaftContact& contact : shaft_) contact.position = needle.held_position(std::max(0.0, contact.arclength));
}

ContactLaw Contacts::law_of(const Contact& contact, Effects effects) const {
    ContactLaw law;
    if (contact.layer == outside && !in_air_) return law;
    for (const auto& effect : effects) effect->add_to(contact, law);
    return law;
}

bool Contacts::finds_own_track(const Vector3& touched) const {
    return track_.begun() && (touched - track_.entry()).norm() <= radius_;
}

void Contacts::arrange(const NeedleModel& needle, const TissueModel& tissue, Effects effects, double time,
                       ContactSet& set) const {
    set.clear();
    if (in_air_) {
        add_tip_in_air(needle, effects, time, set);
        return;
    }
    ContactPoint point{.material = touch_, .span = Vector3::Zero(), .arclength = length_, .tip = true};
    TipState tip = tip_;
    if (tip == TipState::free) {
        const Vector3 now = needle.held_position(length_);
        double entry = tip_known_ ? tissue.entry(tip_position_, now) : -1.0;
        Vector3 from = tip_position_;
        if (entry < 0.0 &&
            tissue.locate(now).layer != outside) {    // it came in without crossing the surface: through its own axis
            from = needle.position(0.0);
            entry = tissue.entry(from, now);
        }
        if (entry < 0.0) return;
        point.material = from + entry * (now - from);
        tip = finds_own_track(point.material) ? TipState::inside : TipState::touching;
    }
    if (tip == TipState::inside) point.material = track_.material(way_);
    set.points.push_back(point);
    set.rows.push_back(tip_row(tip, point, needle, tissue, effects, time));
    for (int i = 0; i < shaft_contacts(); ++i) add_shaft(i, needle, tissue, effects, time, set);
}

ContactRow Contacts::tip_row(TipState tip, const ContactPoint& point, const NeedleModel& needle, const TissueModel& tissue,
                             Effects effects, double time) const {
    const Vector3 axis = needle.cut_direction(length_);
    const Contact contact{.tip = true,
                          .inside = tip == TipState::inside,
                          .layer = tissue.locate(point.material).layer,
                          .coverage = 0.0,
                          .axial_force = tip_contact_.axial_force,
                          .slip = tip_contact_.slip,
                          .slipping = tip_contact_.slipping,
                          .needle_radius = radius_,
                          .axis = axis,
                          .time = time};
    const ContactLaw law = law_of(contact, effects);
    ContactRow row;
    row.frame = frame_of(axis);
    row.lateral = contact.layer != outside;
    row.upper = law.tip_limited || contact.layer == outside ? law.tip_limit : infinity;
    row.gap = tip == TipState::inside ? track_.cut() - way_ : 0.0;
    row.own_force = law.own_force;
    if (letting_go_) {
        row.lateral = false;
        row.upper = 0.0;
        row.own_force.setZero();
    }
    tip_contact_.recall(row);
    row.old_position = tip_position_;
    return row;
}

// What it moves in a step, from where it stands, is the way that a load on it works along; what holds it stays where it is.
void Contacts::add_tip_in_air(const NeedleModel& needle, Effects effects, double time, ContactSet& set) const {
    const ContactPoint point{
        .material = stand_.value_or(needle.held_position(length_)), .span = Vector3::Zero(), .arclength = length_, .tip = true};
    const Vector3 axis = needle.held_tangent(length_);
    const Contact contact{.tip = true,
                          .inside = false,
                          .layer = outside,
                          .coverage = 0.0,
                          .axial_force = tip_contact_.axial_force,
                          .slip = tip_contact_.slip,
                          .slipping = tip_contact_.slipping,
                          .needle_radius = radius_,
                          .axis = axis,
                          .time = time};
    const ContactLaw law = law_of(contact, effects);
    ContactRow row;
    row.frame = frame_of(axis);
    row.lateral = law.held || *in_air_ != Ends::clamped_free;
    row.upper = law.held ? infinity : 0.0;
    row.lower = -row.upper;
    row.own_force = law.own_force;
    tip_contact_.recall(row);
    row.old_position = tip_position_;
    set.points.push_back(point);
    set.rows.push_back(row);
    set.in_air = true;
}

void Contacts::add_shaft(int i, const NeedleModel& needle, const TissueModel& tissue, Effects effects, double time,
                         ContactSet& set) const {
    const ShaftContact& shaft = shaft_[i];
    const ContactPoint point{.material = track_.node(i),
                             .span = track_.covered_span(i, way_),
                             .arclength = std::max(0.0, shaft.arclength),
                             .tip = false};
    const Vector3 axis = needle.held_tangent(point.arclength);
    const bool past_base = shaft.arclength < 0.0;
    const Contact contact{.tip = false,
                          .inside = true,
                          .layer = past_base ? outside : tissue.locate(point.material + 0.5 * point.span).layer,
                          .coverage = track_.covered(i, way_),
                          .axial_force = shaft.axial_force,
                          .slip = shaft.slip,
                          .slipping = shaft.slipping,
                          .needle_radius = radius_,
                          .axis = axis,
                          .time = time};
    const ContactLaw law = law_of(contact, effects);
    ContactRow row;
    row.frame = frame_of(axis);
    // A piece shorter than the needle is thick stands where the tip stands: the tip's lateral row holds both.
    row.lateral = !past_base && contact.coverage > radius_;
    row.first_held = row.lateral && !shaft.held;
    row.beside = shaft.beside - shaft.beside.dot(axis) * axis;
    row.upper = law.axial_limit;
    row.lower = -law.axial_limit;
    row.own_force = law.own_force;
    shaft.recall(row);
    row.old_position = shaft.position;
    set.points.push_back(point);
    set.rows.push_back(row);
}

void Contacts::ShaftContact::take(const ContactRow& row) {
    held = row.lateral;
    beside = row.lateral ? row.beside : Vector3::Zero();
    force = row.force;
    effect_force = row.effect_force;
    sideways = row.sideways;
    excess = row.excess;
    configurational = row.configurational;
    axial_force = row.axial_force;
    slip = row.advance;
    slipping = row.advance != 0.0;
    arclength -= row.advance;
}

void Contacts::ShaftContact::recall(ContactRow& row) const {
    row.old_force = force;
    row.old_effect_force = effect_force;
    row.old_sideways = sideways;
    row.old_excess = excess;
    row.old_configurational = configurational;
    row.old_advance = slip;
}

ContactChange Contacts::absorb(const NeedleModel& needle, const TissueModel& tissue, const ContactSet& set) {
    if (set.empty()) return {};
    const ContactRow& row = set.rows.front();
    tip_contact_.take(row);
    if (in_air_) {
        stand_ = set.points.front().material + row.frame * row.offset;
        return {};
    }
    if (letting_go_) {
        withdraw();
        return {};
    }
    const bool arrived = tip_ == TipState::free;
    if (arrived && !finds_own_track(set.points.front().material)) {
        tip_ = TipState::touching;
        touch_ = set.points.front().material;
    } else if (arrived) {
        tip_ = TipState::inside;
        way_ = 0.0;
    }
    if (tip_ == TipState::inside) {
        ContactChange change = absorb_inside(needle, tissue, set);
        if (arrived) change.event = tip_ == TipState::inside ? "back in its track" : nullptr;
        return change;
    }
    if (row.axial_force >= row.upper && row.advance > 0.0) {
        tip_ = TipState::inside;
        way_ = 0.0;
        track_.begin(touch_, needle.cut_direction(length_));
        ContactChange change = absorb_inside(needle, tissue, set);
        change.punctured = true;
        change.event = "punctured";
        return change;
    }
    if (row.axial_force <= 0.0 && row.advance < 0.0) {
        let_go();
        return {.event = arrived ? nullptr : "lifted off"};
    }
    return {.event = arrived ? "touched" : nullptr};
}

ContactChange Contacts::absorb_inside(const NeedleModel& needle, const TissueModel& tissue, const ContactSet& set) {
    ContactChange change{.layer = tissue.locate(track_.material(way_)).layer};
    for (int i = 0; i < shaft_contacts(); ++i) shaft_[i].take(set.rows[i + 1]);
    way_ += set.rows.front().advance;
    if (way_ <= 0.0) {
        let_go();
        change.event = "withdrawn";
        return change;
    }
    change.cut = track_.reach(way_, needle.cut_direction(length_));
    const int layer = tissue.locate(track_.material(way_)).layer;
    const bool now_outside = layer == outside;
    if (now_outside && !outside_) {
        track_.leave(way_);
        change.event = "left the tissue";
    } else if (layer != change.layer && !now_outside && !outside_) {
        change.event = "crossed an interface";
    }
    outside_ = now_outside;
    lay_shaft();
    return change;
}

// One shaft contact for each piece of track that the tip has passed.
void Contacts::lay_shaft() {
    int wanted = 1;
    while (wanted < track_.nodes() && track_.way_of(wanted) <= way_) ++wanted;
    while (shaft_contacts() > wanted && shaft_.back().force.isZero(0.0)) shaft_.pop_back();    // once it carries nothing
    while (shaft_contacts() < wanted) shaft_.push_back({.arclength = length_ - (way_ - track_.way_of(shaft_contacts()))});
}

// The tip is out. Where a contact still carries something, one more step without it comes first.
void Contacts::let_go() {
    letting_go_ = true;
    way_ = 0.0;
    bool carries = !tip_contact_.force.isZero(0.0);
    for (const ShaftContact& contact : shaft_) carries = carries || !contact.force.isZero(0.0);
    if (!carries) withdraw();
}

void Contacts::withdraw() {
    letting_go_ = false;
    tip_ = TipState::free;
    tip_contact_ = {.arclength = length_};
    shaft_.clear();
    way_ = 0.0;
    outside_ = false;
}

}    // namespace stylet::core
