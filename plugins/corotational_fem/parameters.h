// What a scene may say of this tissue, beside what it says of any.
#pragma once

#include <stylet/parameters.h>

namespace stylet::corotational_fem {

inline constexpr Parameter parameters[] = {
    optional(finer_above(vector3(
        "cells", "1", "cells along x, y and z, of six tetrahedra each, that the block is cut into; either this or `mesh`"))),
    optional(
        file("mesh", "tetrahedral Gmsh mesh (.msh 2.2 or 4.1) whose regions are named as the layers; either this or `cells`")),
    optional(number("mesh_unit", "m", positive, "length of one unit of the mesh's file; wanted with `mesh`")),
    optional(text("held", "physical group of the mesh whose nodes are held; left out, those on the faces that `fixed` names")),
    finer_above(
        choice("pressure", "tetrahedron patch",
               "what has a pressure of its own: each tetrahedron, which locks where Poisson's ratio nears 0.5, or each patch of "
               "about six")),
    choice("dynamics", "quasi_static implicit", "without inertia, or with it by backward Euler"),
    optional(vector3("gravity", "m/s^2", "acceleration of free fall; left out, the tissue weighs nothing")),
    optional(number("damping_time", "s", positive,
                    "viscous stress is this times the elastic stress of the strain's rate; left out, the tissue damps nothing")),
    finer_below(choice("solver", "newton quasi_newton",
                       "newton: to the last digit in double precision, slowly; quasi_newton: to `accuracy`, fast")),
    optional(finer_below(number(
        "accuracy", "1", {.least = 1e-5, .greatest = 0.1},
        "of the displacements, what quasi_newton aims at in each step: over a swing a few times as much; wanted with it"))),
    optional(choice("load_shared_by", "nodes area",
                    "what bears the force on a patch: the surface's nodes in it, each as much, or the surface's area in it, "
                    "which is the same load for every mesh; left out, nodes")),
};

}    // namespace stylet::corotational_fem
