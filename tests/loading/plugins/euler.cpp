#include <stylet/buckling_model.h>

namespace {

class Euler : public stylet::BucklingModel {
public:
    explicit Euler(const stylet::Setup&) {}
    double critical_load(const stylet::Column& column) const override { return column.free_length; }
};

}    // namespace

STYLET_PLUGIN(Euler, "euler", stylet::no_parameters, .summary = "A buckling model for tests: the length is the load",
              .formula = "none", .source = "none", .validity = "tests")
