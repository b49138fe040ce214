// The internal forces of a mesh in single precision, as fast as the processor can.
#pragma once

#include "fast/element_pass.h"
#include "fast/gather.h"
#include "mesh/mesh.h"

#include <stylet/workers.h>

#include <span>
#include <vector>

namespace stylet::corotational_fem {

/// f = ∂Ψ/∂u of the co-rotational energy that solid/solid.h states, and its damping forces, from nodal displacements in some
/// order of the free nodes.
///
/// Single precision: a displacement u resolves strains of 6e-8 u/h in a tetrahedron of size h; beyond that forces are exact to
/// some 1e-6 of their own size, however small the strain. Sums over tetrahedra are in double precision. The results are the same
/// bits for any number of threads, and on any two processors whose instruction sets are the same.
///
/// Allocates when made, never later.
class ElementForces {
public:
    /// `places` says of each mesh node its place in the nodal vectors, [0, n) of a free one and n of a fixed one. `workers` must
    /// outlive it.
    ElementForces(const Mesh& mesh, std::span<const Material> materials, std::span<const int> places, bool share_pressure,
                  bool damped, Workers& workers, InstructionSet set = best_instruction_set());

    /// Fills `forces` (n, [N]) for displacements u (n + 1, [m], the last one zero).
    ElementSums strain(const Float4* u, Float4* forces);

    /// The same, and remembers how the tetrahedra stand, for steps that are damped from there on.
    ElementSums start(const Float4* u, Float4* forces);

    /// The same with the forces of damping on the way from `from` (n + 1, [m]), where the last start was, for `rate` = τ/dt [1].
    ElementSums strain(const Float4* u, const Float4* from, double rate, Float4* forces);

private:
    struct Member {
        int batch, lane;
        float weight;    // [1] its part of the patch's volume
    };

    void group(const Mesh& mesh, std::span<const int> order);
    struct Kernels {
        ElementKernels::Measure measure;
        ElementKernels::Strain strain;
    };
    ElementSums run(ElementPass pass, const Kernels& kernels, Float4* forces);
    void average(std::vector<BatchDilatations>& dilatations);

    const ElementKernels& kernels_;
    Workers& workers_;
    std::vector<ElementBatch> batches_;
    std::vector<CornerForces> corner_forces_;
    Gather gather_;

    std::vector<BatchRotations> start_rotations_;    // where it is damped

    // Where pressure is shared.
    std::vector<BatchRotations> rotations_;
    std::vector<BatchDilatations> dilatations_, swellings_;
    std::vector<Member> members_;    // of one patch after another
    std::vector<int> patches_;       // the first member of each, and the end
};

}    // namespace stylet::corotational_fem
