#include "fast/gather.h"

#include "fast/shares.h"

#include <gtest/gtest.h>

#include <vector>

namespace stylet::corotational_fem {
namespace {

std::vector<Float4> counted(int corners) {
    std::vector<Float4> forces(corners);
    for (int k = 0; k < corners; ++k) {
        const auto value = static_cast<float>(k + 1);
        forces[k] = {value, -value, 2.0F * value, 0.0F};
    }
    return forces;
}

TEST(Gather, SumsAtEachNodeTheCornersThatAreThere) {
    const std::vector<int> places{0, 2, 2, 3, 0, 2, 3, 9};
    const std::vector<Float4> corners = counted(static_cast<int>(places.size()));
    std::vector<Float4> sums(3);
    Gather(places, 3).sum(corners.data(), sums.data(), one_thread());
    EXPECT_EQ(sums[0].x, 1.0F + 5.0F);
    EXPECT_EQ(sums[1].x, 0.0F);
    EXPECT_EQ(sums[2].x, 2.0F + 3.0F + 6.0F);
    EXPECT_EQ(sums[2].y, -11.0F);
    EXPECT_EQ(sums[2].z, 22.0F);
}

TEST(Gather, SumsEveryNodeOnceHoweverUnevenTheyAre) {
    std::vector<int> places(1000, 7);    // one node with nearly all corners
    for (int node = 0; node < 40; ++node) places.push_back(node);
    std::vector<Float4> corners(places.size(), Float4{1.0F, 1.0F, 1.0F, 0.0F});
    std::vector<Float4> sums(40);
    Gather(places, 40).sum(corners.data(), sums.data(), one_thread());
    for (int node = 0; node < 40; ++node) EXPECT_EQ(sums[node].x, node == 7 ? 1001.0F : 1.0F);
}

TEST(Gather, OfNoNodesDoesNothing) {
    Gather(std::vector<int>{0, 1}, 0).sum(counted(2).data(), nullptr, one_thread());
}

}    // namespace
}    // namespace stylet::corotational_fem
