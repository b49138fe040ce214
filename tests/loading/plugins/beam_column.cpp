#include "still_bodies.h"

#include <stylet/buckling_model.h>

namespace {

/// Asks the buckling model that it is given, so that a test can see it arrive.
class BeamColumn : public stylet::still::Needle {
public:
    explicit BeamColumn(const stylet::Setup& setup) : Needle(setup) {
        const stylet::NeedleSetup& needle = *setup.needle;
        if (needle.radius < 1e-6) throw stylet::Error("radius", "found a needle too thin for this model");
        if (setup.buckling == nullptr) return;
        critical_load_ = setup.buckling->critical_load({.bending_stiffness = needle.bending_stiffness(),
                                                        .free_length = needle.length,
                                                        .radius = needle.radius,
                                                        .ends = needle.ends});
    }
};

}    // namespace

STYLET_PLUGIN(BeamColumn, "beam_column", stylet::no_parameters, .summary = "A needle for tests", .formula = "none",
              .source = "none", .validity = "tests")
