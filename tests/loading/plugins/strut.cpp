#include <stylet/buckling_model.h>

namespace {

class Strut : public stylet::BucklingModel {
public:
    explicit Strut(const stylet::Setup& setup) : strength_(setup.parameters.number("strength")) {}
    double critical_load(const stylet::Column& column) const override { return strength_ * column.radius * column.radius; }

private:
    double strength_;    // [Pa]
};

constexpr stylet::Parameter parameters[] = {
    stylet::number("strength", "Pa", stylet::positive, "load per square of the radius"),
    stylet::optional(stylet::choice("form", "printed consistent", "which equation; left out, consistent")),
};

}    // namespace

STYLET_PLUGIN(Strut, "strut", parameters, .summary = "A buckling model with parameters of its own, for tests", .formula = "none",
              .source = "none", .validity = "tests")
