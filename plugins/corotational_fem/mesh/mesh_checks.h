#pragma once

#include "mesh/mesh.h"

#include <string>

namespace stylet::corotational_fem {

/// Bounds of a tetrahedron's shape. As it flattens, the largest eigenvalue of its stiffness grows as the cotangent of its
/// smallest dihedral angle: at half a degree it is about a hundred times that of its well-shaped neighbours, which costs two of
/// the seven digits that single precision has, and no number of iterations brings them back. A needle of a tetrahedron has good
/// angles, and a stiffness out of proportion all the same. Kuhn cells stay within both bounds up to a hundred times as wide as
/// they are high.
inline constexpr double least_dihedral_angle = 0.5;    // [degrees]
inline constexpr double greatest_aspect = 1e3;         // longest edge over least height

/// The smallest angle between two faces of a tetrahedron [degrees].
[[nodiscard]] double smallest_dihedral_angle(const Mesh& mesh, const Tetrahedron& tetrahedron);

/// A tetrahedron's longest edge over its least height; infinite where it is flat.
[[nodiscard]] double aspect_of(const Mesh& mesh, const Tetrahedron& tetrahedron);

/// Whether a tetrahedron of some volume is beyond either bound.
[[nodiscard]] bool is_sliver(const Mesh& mesh, const Tetrahedron& tetrahedron);

/// Throws Error at `key` where a mesh can't be trusted, with all that is wrong: of each kind the first ten, and how many more.
/// - tetrahedra: inverted; without volume; slivers beyond the bounds above; the same one twice; two that overlap at a common
/// face;
/// - nodes that belong to no tetrahedron: without mass or stiffness, singular;
/// - parts that nothing holds, singular: a part is what is connected through faces, and it is held where three of its nodes that
///   are not on one line are fixed or belong to a part that is held (less than that and it can turn about them);
/// - no node that is free;
/// - more than one body. Each might be held and yet it is refused: bodies of a mesh go through each other, and nearly always they
///   are one tissue whose common nodes were not merged.
void check_mesh(const Mesh& mesh, const MeshTags& tags, const std::string& key);

}    // namespace stylet::corotational_fem
