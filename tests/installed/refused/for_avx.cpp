#include <stylet/force_model.h>

class ForAvx final : public stylet::ForceModel {
public:
    explicit ForAvx(const stylet::Setup&) {}
};

STYLET_PLUGIN(ForAvx, "for_avx", stylet::no_parameters, .summary = "An effect that is built for a wider vector unit",
              .formula = "none", .source = "none", .validity = "tests")
