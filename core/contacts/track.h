#pragma once

#include <stylet/types.h>

#include <limits>
#include <vector>

namespace stylet::core {

/// The way that the tip cut, in undeformed tissue: straight pieces of one contact spacing, each in the direction in which the
/// needle pointed when the tip began it. It stays when the needle is withdrawn, so that nothing is cut twice.
class Track {
public:
    Track(double spacing, int most_nodes) : spacing_(spacing) { nodes_.reserve(most_nodes); }

    void begin(const Vector3& entry, const Vector3& direction) {
        nodes_.clear();
        nodes_.push_back({entry, direction});
        cut_ = 0.0;
        exit_ = std::numeric_limits<double>::infinity();
    }
    [[nodiscard]] bool begun() const { return !nodes_.empty(); }
    [[nodiscard]] const Vector3& entry() const { return nodes_.front().material; }

    /// The tip is now `way` [m] from the entry, and points to `direction`. Returns how much of that is newly cut [m].
    double reach(double way, const Vector3& direction);

    /// The tip left the tissue's extent here.
    void leave(double way) { exit_ = std::min(exit_, way); }

    [[nodiscard]] Vector3 material(double way) const;    // [m] undeformed point at a way from the entry
    [[nodiscard]] Vector3 node(int i) const { return nodes_[i].material; }
    [[nodiscard]] double way_of(int i) const { return i * spacing_; }
    [[nodiscard]] int nodes() const { return static_cast<int>(nodes_.size()); }

    /// How much of the piece at node `i` has tissue around it and a needle in it, with the tip at `way` [m].
    [[nodiscard]] double covered(int i, double way) const;
    [[nodiscard]] Vector3 covered_span(int i, double way) const { return covered(i, way) * nodes_[i].direction; }

    [[nodiscard]] double cut() const { return cut_; }    // [m] longest way the tip has been
    [[nodiscard]] double spacing() const { return spacing_; }

private:
    struct Node {
        Vector3 material;     // [m]
        Vector3 direction;    // unit
    };

    std::vector<Node> nodes_;
    double spacing_;    // [m]
    double cut_ = 0.0;
    double exit_ = std::numeric_limits<double>::infinity();    // [m]
};

}    // namespace stylet::core
