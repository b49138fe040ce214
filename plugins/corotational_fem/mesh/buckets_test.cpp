#include "mesh/buckets.h"

#include <gtest/gtest.h>

#include <iostream>
#include <random>
#include <set>

namespace stylet::corotational_fem {
namespace {

constexpr double margin = 1e-9;    // [m]

/// Boxes of 1 to 3 cm, thrown into a room of 1 × 2 × 0.5 m.
std::vector<Box> boxes(int count) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<Box> boxes;
    for (int i = 0; i < count; ++i) {
        const Vector3 least(unit(random), 2.0 * unit(random), 0.5 * unit(random));
        boxes.push_back({least, least + Vector3(0.01, 0.02, 0.03) * unit(random)});
    }
    return boxes;
}

Vector3 somewhere(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(-0.1, 1.1);
    return {unit(random), 2.0 * unit(random), 0.5 * unit(random)};
}

bool reaches(int, const Box&) {
    return true;
}

TEST(Buckets, AnItemIsListedWhereverItReaches) {
    const std::vector<Box> items = boxes(2000);
    const Buckets buckets(items, margin, reaches);
    for (int i = 0; i < 2000; ++i) {
        for (const Vector3& point : {items[i].least, items[i].greatest, Vector3(0.5 * (items[i].least + items[i].greatest))}) {
            const auto listed = buckets.at(point);
            EXPECT_NE(std::find(listed.begin(), listed.end(), i), listed.end());
        }
    }
}

TEST(Buckets, AListIsShortHoweverManyItemsThereAre) {
    for (const int count : {100, 1000, 10000}) {
        const std::vector<Box> items = boxes(count);
        const double share = static_cast<double>(count) * 6e-6 / 8.0;    // of the room, that all items fill on average
        const Buckets buckets(items, margin, reaches);
        std::mt19937 random(9);
        std::size_t sum = 0;
        for (int i = 0; i < 1000; ++i) sum += buckets.at(somewhere(random)).size();
        const double mean = static_cast<double>(sum) / 1000.0;
        std::cout << count << " items: " << mean << " at a place\n";
        EXPECT_LE(mean, 8.0 * (1.0 + share)) << "an item as large as a bucket reaches into eight";
    }
}

TEST(Buckets, AWayMeetsWhatIsOnItInOrder) {
    const std::vector<Box> items = boxes(500);
    const Buckets buckets(items, margin, reaches);
    std::mt19937 random(2);
    for (int i = 0; i < 100; ++i) {
        const Vector3 from = somewhere(random);
        Vector3 to = somewhere(random);
        if (i % 5 == 0) to.x() = from.x();    // along a plane of the grid
        if (i % 10 == 0) to.y() = from.y();
        std::set<int> met;
        double before = -1.0;
        buckets.along(from, to, [&](std::span<const int> listed, double upto) {
            met.insert(listed.begin(), listed.end());
            EXPECT_GE(upto, before);
            before = upto;
            return true;
        });
        constexpr int steps = 200;
        for (int step = 0; step <= steps; ++step) {
            const Vector3 point = from + (to - from) * step / steps;
            for (int item = 0; item < 500; ++item) {
                EXPECT_TRUE(!items[item].holds(point) || met.contains(item)) << "way " << i;
            }
        }
    }
}

TEST(Buckets, NothingIsListedOutside) {
    const Buckets buckets(boxes(100), margin, reaches);
    EXPECT_TRUE(buckets.at(Vector3(5.0, 0.5, 0.2)).empty());
    EXPECT_TRUE(buckets.at(Vector3(0.5, std::nan(""), 0.2)).empty());
    buckets.along(Vector3(-1.0, 5.0, 0.0), Vector3(2.0, 5.0, 0.0), [](auto, double) {
        ADD_FAILURE() << "this way is past the room";
        return true;
    });
}

TEST(Buckets, StopWhenAsked) {
    const Buckets buckets(boxes(1000), margin, reaches);
    int visits = 0;
    buckets.along(Vector3::Zero(), Vector3(1.0, 2.0, 0.5), [&](auto, double) { return ++visits < 3; });
    EXPECT_EQ(visits, 3);
}

}    // namespace
}    // namespace stylet::corotational_fem
