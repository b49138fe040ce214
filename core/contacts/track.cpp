#include "core/contacts/track.h"

#include <algorithm>

namespace stylet::core {

double Track::reach(double way, const Vector3& direction) {
    if (way <= cut_) return 0.0;
    const double fresh = std::min(way, exit_) - std::min(cut_, exit_);
    cut_ = way;
    while (way >= way_of(nodes()) && nodes_.size() < nodes_.capacity()) {
        nodes_.push_back({nodes_.back().material + spacing_ * nodes_.back().direction, direction});
    }
    return fresh;
}

Vector3 Track::material(double way) const {
    const int piece = std::clamp(static_cast<int>(way / spacing_), 0, nodes() - 1);
    return nodes_[piece].material + (way - way_of(piece)) * nodes_[piece].direction;
}

double Track::covered(int i, double way) const {
    return std::clamp(std::min(way, exit_) - way_of(i), 0.0, spacing_);
}

}    // namespace stylet::core
