#include "fast/large_pages.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace stylet::corotational_fem {
namespace {

TEST(LargePages, AreZeroAndAligned) {
    for (const std::size_t bytes : {std::size_t{64}, std::size_t{100'000}, std::size_t{9'000'000}}) {
        LargePages pages(bytes);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(pages.at(0)) % 64, 0U);
        EXPECT_EQ(*pages.at(0), std::byte{0});
        EXPECT_EQ(*pages.at(bytes - 1), std::byte{0});
        *pages.at(bytes - 1) = std::byte{7};
        const LargePages moved = std::move(pages);
        EXPECT_EQ(*moved.at(bytes - 1), std::byte{7});
    }
}

TEST(LargePages, OfNothingAreNothing) {
    EXPECT_EQ(LargePages(0).at(0), nullptr);
}

}    // namespace
}    // namespace stylet::corotational_fem
