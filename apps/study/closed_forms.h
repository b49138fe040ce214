// Formulas that know the answer of a scene.
#pragma once

#include "apps/study/outcome.h"
#include "apps/study/study.h"
#include "core/scene/scene.h"

#include <span>
#include <string>
#include <vector>

namespace stylet::study {

/// Every closed form, by the name a study gives it:
///
/// - `elastica`: hand_force over travel of an inextensible column in air that a hand pushes against a pin, its ends held in any
/// way
///   (apps/study/elastica_load.h). At travel 0 any force from 0 to P_cr is right, so the curve begins past it, where it tends to
///   P_cr; it ends at 0.99 of the length.
/// - `euler`: critical_load in air, k EI/L² (Euler 1757; k in elastica_load.h). Valid for a straight, slender needle.
/// - `flat_punch`: tip_force or hand_force over depth until the tip punctures, F = 2a E* δ with a the needle's radius and
///   E* = E/(1 − ν²) of a homogeneous tissue, 0 above the surface (Boussinesq 1885; Johnson 1985, eq. 3.36). Valid for a rigid
///   flat end on a block at least 20a wide and deep, pushed so slowly that nothing swings and by a needle that neither bows nor
///   shortens. The curve ends where F is the rupture force.
/// - `love`: patch_displacement in the end, of a rectangle under an evenly shared force along z on a homogeneous tissue
///   (apps/study/loaded_rectangle.h).
[[nodiscard]] std::vector<std::string> closed_form_names();

/// What a page calls it: "elliptic integrals (closed form)". Throws Error where there is none of this name.
[[nodiscard]] std::string closed_form_title(const ClosedForm& form);

/// What the scene's measure should be: of a curve at those of the samples x [SI] where the formula holds (all of them may be
/// left out; the outcome is then missing). Throws Error where there is no closed form of this name or where scene or measure are
/// not what it is about: what was found and what was wanted. To check that alone, give no samples.
[[nodiscard]] Outcome closed_form(const ClosedForm& form, const Measure& measure, const core::Scene& scene,
                                  std::span<const double> x);

}    // namespace stylet::study
