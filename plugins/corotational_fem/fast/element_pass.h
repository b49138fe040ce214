// The element pass: what sixteen tetrahedra at a time read and write, and its loops for each kind of processor (kernels.h).
#pragma once

#include "fast/kernels.h"
#include "fast/lanes.h"

namespace stylet::corotational_fem {

/// Sixteen tetrahedra. One that isn't there stands at the zero node with zeros everywhere else.
struct alignas(64) ElementBatch {
    int nodes[4][lanes];             // places in the nodal vectors
    float gradients[3][3][lanes];    // [1/m] ∇N of the corners 1 to 3, xyz of each; that of corner 0 is minus their sum
    float shear[lanes];              // [N·m] 2μV
    float lame[lanes];               // [N·m] λV
};

/// The forces of a batch's tetrahedra [N] at each of their corners.
struct alignas(64) CornerForces {
    Float4 of[4][lanes];    // second index: slot_of(lane)
};

/// As the transposed registers fall.
constexpr int slot_of(int lane) {
    return lane % 4 * 4 + lane / 4;
}

struct alignas(64) BatchRotations {
    float differences[3][3][lanes];    // [1] R − I
};

struct alignas(64) BatchDilatations {
    float theta[lanes];    // [1]
};

/// Views; what a loop doesn't use may be null.
struct ElementPass {
    const ElementBatch* batches = nullptr;
    const Float4* u = nullptr;                    // [m] displacement of each place
    CornerForces* forces = nullptr;               // of each batch
    const Float4* from = nullptr;                 // [m] displacement at the step's start
    float rate = 0.0F;                            // [1] τ/dt
    BatchRotations* start_rotations = nullptr;    // of each batch, at the step's start
    BatchRotations* rotations = nullptr;          // of each batch
    BatchDilatations* dilatations = nullptr;      // θ
    BatchDilatations* swellings = nullptr;        // its change since the step's start, as the damper sees it
};

struct ElementSums {
    double elastic = 0.0;       // [J]
    double dissipated = 0.0;    // [J] by damping, on the way from `from`
    bool inverted = false;      // whether a tetrahedron is turned inside out
};

/// Each takes the batches [first, last). Whatever the displacements are, what comes out is finite as long as it can be told in
/// single precision, and the same bits every time.
struct ElementKernels {
    using Strain = ElementSums (*)(const ElementPass& pass, int first, int last);
    using Measure = bool (*)(const ElementPass& pass, int first, int last);

    Strain strain;            // forces
    Strain strain_started;    // forces; fills start_rotations
    Strain strain_damped;     // forces, with those of damping

    // Where pressure is shared: first rotations and dilatations, damped with swellings too, and whether a tetrahedron is turned
    // inside out; then, with both averaged, forces.
    Measure measure, measure_damped;
    Strain push, push_started, push_damped;
};

/// Of a set that this processor supports.
[[nodiscard]] const ElementKernels& element_kernels(InstructionSet set);

/// R − I of F = I + G by a singular value decomposition in double precision, det R = +1 (row by row): for the few tetrahedra that
/// are flat, inverted, collapsed or otherwise not for the loops' iteration. Of a G that is not finite, zero.
void careful_rotation(const float gradient[9], float rotation[9]);

}    // namespace stylet::corotational_fem
