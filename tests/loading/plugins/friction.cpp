#include <stylet/force_model.h>

namespace {

class Friction : public stylet::ForceModel {
public:
    explicit Friction(const stylet::Setup& setup) : per_length_(setup.parameters.number("per_length")) {}
    void add_to(const stylet::Contact& contact, stylet::ContactLaw& law) const override {
        law.add_axial(per_length_ * contact.coverage);
    }

private:
    double per_length_;
};

constexpr stylet::Parameter parameters[] = {
    stylet::number("per_length", "N/m", stylet::positive, "friction per inserted length"),
};

}    // namespace

STYLET_PLUGIN(Friction, "friction", parameters, .summary = "An effect for tests", .formula = "none", .source = "none",
              .validity = "tests")
