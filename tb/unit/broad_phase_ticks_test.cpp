// broad_phase_ticks_test.cpp - what sweep keeps from tick to tick, in worlds too large for brute
// force.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <string>

#include "tb/unit/broad_phase_worlds.h"

namespace {

using namespace collision;
using namespace tb;

// By a sort and a sweep of its own: too many for brute force.
Sorted sorted_sweep(const Boxes& boxes) {
    std::vector<std::uint32_t> order(boxes.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](auto a, auto b) { return boxes[a].min.x < boxes[b].min.x; });
    Sorted pairs;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Aabb& a = boxes[order[i]];
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            const Aabb& b = boxes[order[j]];
            if (b.min.x > a.max.x) break;
            if (gap(a.min.y, a.max.y, b.min.y, b.max.y) <= 0)
                pairs.push_back(pair_of(order[i], order[j]));
        }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

// In each tick all boxes to the right of `calm` get new places there; the others stay.
TEST(Sweep, FindsAllPairsWhereverItsOrderIsLost) {
    std::mt19937 random(5);
    std::uniform_int_distribution<std::int64_t> place(0, 1'000'000), sides(0, 10'000);
    Boxes boxes;
    for (int i = 0; i < 5000; ++i)
        boxes.push_back(box(place(random), place(random), sides(random), sides(random)));
    Finder find = finder<Sweep>("sweep");
    for (const std::int64_t calm : {1'000'000, 999'000, 500'000, 2'000, 0}) {
        for (Aabb& b : boxes)
            if (b.min.x > calm)
                b = box(calm + 1 + place(random) % (1'000'000 - calm), b.min.y, 5'000, 5'000);
        const Sorted truth = sorted_sweep(boxes);
        EXPECT_EQ(find(boxes), truth) << "calm up to " << calm;
    }
}

}  // namespace
