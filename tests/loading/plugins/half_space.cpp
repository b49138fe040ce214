#include "still_bodies.h"

using stylet::still::Tissue;

STYLET_PLUGIN(Tissue, "half_space", stylet::no_parameters, .summary = "A tissue for tests", .formula = "none", .source = "none",
              .validity = "tests")
