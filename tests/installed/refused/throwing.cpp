#include <stylet/force_model.h>

#include <stdexcept>

class Throwing final : public stylet::ForceModel {
public:
    explicit Throwing(const stylet::Setup&) { throw std::out_of_range("a bug in its constructor"); }
};

STYLET_PLUGIN(Throwing, "throwing", stylet::no_parameters, .summary = "An effect that cannot be made", .formula = "none",
              .source = "none", .validity = "tests")
