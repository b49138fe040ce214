// The sections of a scene: each reads one key of the top map into the scene, and complains of what is wrong.
#pragma once

#include "core/scene/parameter_reader.h"

namespace stylet::core {

void read_tissue(const ValueTree& map, Reading& reading, Scene& scene);
void read_needle(const ValueTree& map, Reading& reading, Scene& scene);
void read_effects(const ValueTree& list, Reading& reading, Scene& scene);
void read_device(const ValueTree& map, Reading& reading, Scene& scene);
void read_coupling(const ValueTree& map, Reading& reading, Scene& scene);
void read_run(const ValueTree& map, Reading& reading, Scene& scene);
void read_record(const ValueTree& list, Reading& reading, Scene& scene);

}    // namespace stylet::core
