#include "still_bodies.h"

using stylet::still::Tissue;

STYLET_PLUGIN_WITHOUT_PARAMETERS(Tissue, "half_space", "A tissue for tests", "none")
