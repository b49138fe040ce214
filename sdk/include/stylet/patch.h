#pragma once

#include <stylet/types.h>

namespace stylet {

/// A part of the tissue's undeformed surface: what of it lies in this box, its faces counted in. A side of no length is a plane.
struct Patch {
    Vector3 centre = Vector3::Zero();    // [m]
    Vector3 size = Vector3::Zero();      // [m] along x, y, z
};

}    // namespace stylet
