// The factor in single precision, laid out for the processor: the fast direct solve.
#pragma once

#include "fast/factor.h"
#include "fast/kernels.h"
#include "fast/lanes.h"

#include <stylet/workers.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace stylet::corotational_fem {

enum class Storage : std::uint8_t { single, half };    // IEEE numbers of 32 or 16 bits

/// Half where the processor converts it.
[[nodiscard]] Storage smallest_storage(InstructionSet set);

/// A⁻¹ of a Factor, which it needs no longer once made, in single precision.
///
/// Each node's unknowns are scaled by C = √(trace/3) of its block of S⁻¹, so that C⁻¹ S⁻¹ C⁻¹ has ones on its diagonal and no
/// number beyond them: none overflows when it is stored in half precision. M becomes C M C⁻¹, whose numbers stay below the root
/// of how much softer a node is with all others held or let go. Rounding keeps what is symmetric symmetric: the operator
/// is that of *a* symmetric matrix, whatever the storage, and its inverse is within the storage's accuracy of A's.
///
/// Vectors are in places (Dissection), with one entry more for the node that stands for all fixed ones: its force is not read and
/// its displacement not written. Nothing allocates, locks or throws but the constructor. Results are the same bits for any number
/// of threads.
class Panels {
public:
    /// The dissection must outlive it. Needs a supported set, and one that converts halves where they are asked for.
    Panels(const Factor& factor, Storage storage, InstructionSet set);

    /// x = A⁻¹ rhs.
    void solve(const Float4* rhs, Float4* x, Workers& workers) {
        forward(rhs, workers);
        backward(x, workers);
    }

    /// The first half of a solve: what Reach needs to know of a right-hand side.
    void forward(const Float4* rhs, Workers& workers);

    /// The second half: x of what `forward` left, and of the forces on footprints added since. May be called again.
    void backward(Float4* x, Workers& workers);

    [[nodiscard]] const Dissection& dissection() const { return dissection_; }
    [[nodiscard]] std::size_t bytes() const { return blocks_.size() * sizeof(Line); }    // of the blocks
    [[nodiscard]] Storage storage() const { return storage_; }

private:
    friend class Reach;

    struct alignas(64) Line {    // of the cache
        std::byte bytes[64];
    };

    // Where the parts of a supernode lie.
    struct Part {
        std::size_t inverse, below;    // [lines] in blocks_
        int own_tiles, row_tiles;
        int own;      // in swept_ and moved_
        int slots;    // in slots_: where each of its rows lies in swept_ and moved_
    };

    // A group has its own nodes and those outside to itself in swept_ and moved_.
    struct Room {
        int begin, size, outside;
        int scratch;                     // [tiles' columns] in scratch_
        int slots;                       // in outside_slots_: where its parent has each of those outside
        int children_begin, children;    // in children_: groups
    };

    void lay_out();
    void pack(const Factor& factor);
    void sweep(const Group& group, const Room& room, const Float4* rhs);
    void substitute(const Group& group, const Room& room, Float4* x);

    const Dissection& dissection_;
    Storage storage_;
    PanelProducts products_;
    decltype(PanelKernels::dots) dots_;
    std::vector<Line> blocks_;
    std::vector<float> scale_;    // of each place: C
    std::vector<Part> parts_;     // of each supernode
    std::vector<Room> rooms_;     // of each group
    std::vector<int> slots_, outside_slots_, children_;
    std::vector<std::array<int, 2>> stages_;    // first group and number of groups
    std::vector<Float4>
        swept_;    // the right-hand side, forward-swept: of own nodes r, of those outside what is taken from theirs
    std::vector<Float4> moved_;    // the solution, scaled
    std::vector<Line> scratch_;
};

}    // namespace stylet::corotational_fem
