#pragma once

#include <stylet/plugin.h>

namespace stylet {

/// A straight needle as a column: what is in air, from the base to the surface, and beyond it what is in the tissue.
struct Column {
    double bending_stiffness;    // [N·m²] EI
    double free_length;          // [m] in air
    double inserted = 0.0;       // [m] in the tissue, from the surface to the tip
    double depth = 0.0;          // [m] of the tip below the surface: `inserted`, but for a needle that goes in at a slant
    double radius;               // [m] outer
    Ends ends;                   // of the whole column for a model that knows what tissue does, else of the free length alone

    [[nodiscard]] double length() const { return free_length + inserted; }    // [m]
};

/// The axial load at which a straight column first has a bent neighbour. A model that knows what tissue does takes it for a
/// Winkler foundation: k [Pa] newtons a metre of shaft for a metre of deflection, in each layer its own.
class BucklingModel : public Object {
public:
    static constexpr Role role = Role::buckling;

    /// [N], positive and finite for any column.
    [[nodiscard]] virtual double critical_load(const Column& column) const = 0;
};

}    // namespace stylet
