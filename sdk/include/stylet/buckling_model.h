#pragma once

#include <stylet/plugin.h>

namespace stylet {

/// A column: the free length of a needle.
struct Column {
    double bending_stiffness;    // [N·m²] EI
    double length;               // [m]
    double radius;               // [m]
    Ends ends;
};

/// The axial load at which a straight column first has a bent neighbour.
class BucklingModel : public Object {
public:
    static constexpr Role role = Role::buckling;

    /// [N], positive and finite for any column.
    [[nodiscard]] virtual double critical_load(const Column& column) const = 0;
};

}    // namespace stylet
