#include <stylet/force_model.h>

namespace {

class Fracture : public stylet::ForceModel {
public:
    explicit Fracture(const stylet::Setup& setup)
        : rupture_force_(setup.parameters.number("rupture_force")), toughness_(setup.parameters.number("toughness")) {
        if (toughness_ > 1e6) throw stylet::Error("toughness", "found a tissue tougher than steel");
    }
    void add_to(const stylet::Contact&, stylet::ContactLaw& law) const override { law.add_tip(rupture_force_); }

private:
    double rupture_force_;
    double toughness_;
};

constexpr stylet::Parameter parameters[] = {
    stylet::number("rupture_force", "N", stylet::positive, "tip force at which the surface ruptures"),
    stylet::number("toughness", "J/m^2", stylet::positive, "energy that a new track costs per area"),
};

}    // namespace

STYLET_PLUGIN(Fracture, "fracture", parameters, .summary = "An effect for tests", .formula = "none", .source = "none",
              .validity = "tests")
