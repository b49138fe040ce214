#include <stylet/buckling_model.h>

double defined_nowhere(const stylet::Column& column);

namespace {

class Undefined : public stylet::BucklingModel {
public:
    explicit Undefined(const stylet::Setup&) {}
    double critical_load(const stylet::Column& column) const override { return defined_nowhere(column); }
};

}    // namespace

STYLET_PLUGIN(Undefined, "undefined_symbol", stylet::no_parameters, .summary = "A library that was not linked whole",
              .formula = "none", .source = "none", .validity = "tests")
