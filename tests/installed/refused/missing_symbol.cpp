#include <stylet/force_model.h>

double defined_nowhere(const stylet::Contact& contact);

class MissingSymbol final : public stylet::ForceModel {
public:
    explicit MissingSymbol(const stylet::Setup&) {}
    void add_to(const stylet::Contact& contact, stylet::ContactLaw& law) const override {
        law.add_axial(defined_nowhere(contact));
    }
};

STYLET_PLUGIN(MissingSymbol, "missing_symbol", stylet::no_parameters, .summary = "An effect that is not linked whole",
              .formula = "none", .source = "none", .validity = "tests")
