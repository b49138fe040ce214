#include "tests/whole_scenes/plugins/driven_hand.h"

STYLET_PLUGIN(stylet::whole_scenes::DrivenHand, "driven_hand", stylet::no_parameters, .summary = "A hand that a test moves",
              .formula = "none", .source = "none", .validity = "tests")
