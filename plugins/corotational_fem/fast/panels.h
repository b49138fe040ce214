// The factor in single precision, laid out for the processor: the fast direct solve.
#pragma once

#include "fast/factor.h"
#include "fast/kernels.h"
#include "fast/lanes.h"
#include "fast/large_pages.h"

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
/// Each node's unknowns are scaled by C = √(trace/3) of its block of S⁻¹, so that C⁻¹ S⁻¹ C⁻¹ has numbers of one and less, and M
/// becomes C M C⁻¹, of some ones where materials are alike; it grows with the root of how far they differ, and faithful_panels()
/// sees to it that it stays within what halves can hold. Rounding keeps what is symmetric symmetric: P is the inverse of *a*
/// symmetric matrix, whatever the storage.
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

    /// What `forward` leaves of no forces at all.
    void clear();

    /// The second half: x of what `forward` left, and of the forces on footprints added since. May be called again.
    void backward(Float4* x, Workers& workers);

    [[nodiscard]] const Dissection& dissection() const { return dissection_; }
    [[nodiscard]] std::size_t bytes() const { return bytes_; }    // of the blocks
    [[nodiscard]] Storage storage() const { return storage_; }

private:
    friend class Reach;

    struct alignas(64) Line {    // of the cache
        std::byte bytes[64];
    };

    // Where the parts of a supernode lie.
    struct Part {
        std::size_t inverse, below;    // [bytes] in blocks_
        int own_tiles, row_tiles;
        int load;             // [lines] in loads_
        int nodes;            // where its own nodes begin in nodes_
        int slots;            // in slots_, which says where each of its rows is in nodes_
        int begin, shares;    // in shares_; none: the product is taken on the way back
    };

    // Part of the product with one S⁻¹: its columns of tiles [first, last).
    struct Share {
        int supernode, first, last;
        int answer;    // [lines] in answers_: as many as the supernode has
    };

    // A group's own nodes in nodes_, and behind them its own copy of those outside.
    struct Room {
        int nodes, size, outside;
        int scratch;            // [lines] in scratch_
        int slots;              // in outside_slots_, which says where its parent has those outside
        int begin, children;    // in children_: groups
    };

    void lay_out();
    void tie_groups();
    void share_out();
    [[nodiscard]] int slot(int group, int place) const;
    void pack(const Factor& factor);
    void sweep(int group, const Float4* rhs);
    [[nodiscard]] bool unloaded(const Part& part);
    void multiply(const Share& share);
    void substitute(int group, Float4* x);
    [[nodiscard]] float* loads(const Part& part) { return reinterpret_cast<float*>(loads_.data() + part.load); }

    const Dissection& dissection_;
    Storage storage_;
    const PanelKernels& kernels_;
    const PanelProducts& products_;
    std::size_t bytes_ = 0;
    LargePages blocks_;
    std::vector<float> scale_;    // C of each place
    std::vector<Part> parts_;     // of each supernode
    std::vector<Room> rooms_;     // of each group
    std::vector<int> slots_, outside_slots_, children_;
    std::vector<std::array<int, 2>> stages_;    // first group and number of groups
    std::vector<Line> loads_;                   // the right-hand side, scaled and forward-swept, of each supernode
    std::vector<Share> shares_;
    std::vector<Line> answers_;
    std::vector<Float4> nodes_;    // scaled: on the way forward what is left of the loads, on the way back the solution
    std::vector<Line> scratch_;
};

}    // namespace stylet::corotational_fem
