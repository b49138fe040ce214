#include "tests/whole_scenes/plugins/driven_hand.h"

STYLET_PLUGIN_WITHOUT_PARAMETERS(stylet::whole_scenes::DrivenHand, "driven_hand", "A hand that a test moves", "a test")
