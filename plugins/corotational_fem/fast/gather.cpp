#include "fast/gather.h"

#include "fast/nodal.h"
#include "fast/shares.h"

namespace stylet::corotational_fem {

Gather::Gather(std::span<const int> places, int nodes) : starts_(nodes + 1, 0), shares_(tasks + 1) {
    for (const int place : places) {
        if (place < nodes) ++starts_[place + 1];
    }
    for (int i = 0; i < nodes; ++i) starts_[i + 1] += starts_[i];
    corners_.resize(starts_.back());
    std::vector<int> next(starts_.begin(), starts_.end() - 1);
    for (int corner = 0; corner < static_cast<int>(places.size()); ++corner) {
        if (places[corner] < nodes) corners_[next[places[corner]]++] = corner;
    }
    int node = 0;    // so that each task has as many corners as any
    for (int task = 0; task <= tasks; ++task) {
        while (node < nodes && starts_[node] < share_start(starts_.back(), task)) ++node;
        shares_[task] = task == tasks ? nodes : node;
    }
}

void Gather::sum(const Float4* corners, Float4* sums, Workers& workers) const {
    workers.each(tasks, [&](int task) {
        for (int node = shares_[task]; node < shares_[task + 1]; ++node) {
            Quad even{}, odd{};    // two sums, for an addition takes longer than a load
            int k = starts_[node];
            const int end = starts_[node + 1];
            for (; k + 1 < end; k += 2) {
                even += quad(corners[corners_[k]]);
                odd += quad(corners[corners_[k + 1]]);
            }
            if (k < end) even += quad(corners[corners_[k]]);
            reinterpret_cast<Quad&>(sums[node]) = even + odd;
        }
    });
}

}    // namespace stylet::corotational_fem
