#pragma once

#include "banded_pencil.h"

#include <cstddef>

namespace stylet::winkler {

/// The elements of a beam with cubic Hermite shape functions; the unknowns of node i are its deflection, 2i, and its slope,
/// 2i + 1. Bending stiffness 1.
///
///     K = ∫ N″ᵀN″ dx + ∫ κ NᵀN dx,   G = ∫ N′ᵀN′ dx
///
/// Source: Przemieniecki 1968, Theory of Matrix Structural Analysis, sections 5.6 and 15.2.

/// Adds the bending stiffness and the geometric stiffness of element e, of length h.
void add_beam(BandedPencil& pencil, int e, double h);

/// Adds the foundation κ under the part of element e, of length h, from `begin` to `end` (fractions of it). Exact: Gauss's rule
/// of four points is so for polynomials up to degree 7, these are of degree 6.
void add_foundation(BandedPencil& pencil, int e, double h, double begin, double end, double kappa);

}    // namespace stylet::winkler
