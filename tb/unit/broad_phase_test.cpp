// broad_phase_test.cpp - sweep and simd against brute force
#include <gtest/gtest.h>

#include <random>

#include "tb/unit/broad_phase_worlds.h"

namespace {

using namespace collision;
using namespace tb;

// ---- Agreement with brute force ----

TEST(BroadPhase, KnowsTheCasesWorkedOutByHand) {
    const struct {
        const char* what;
        Boxes boxes;
        Sorted pairs;
    } cases[] = {
        {"no boxes", {}, {}},
        {"one box", {box(0, 0, 4, 4)}, {}},
        {"corners that touch", {box(0, 0, 4, 4), box(4, 4, 4, 4)}, {{0, 1}}},
        {"sides that touch", {box(0, 0, 4, 4), box(1, 4, 4, 4)}, {{0, 1}}},
        {"one unit apart", {box(0, 0, 4, 4), box(5, 0, 4, 4)}, {}},
        {"one unit apart, upwards", {box(0, 0, 4, 4), box(0, 5, 4, 4)}, {}},
        {"one in the other", {box(0, 0, 9, 9), box(3, 3, 1, 1)}, {{0, 1}}},
        {"three points on one place",
         {box(7, 7, 0, 0), box(7, 7, 0, 0), box(7, 7, 0, 0)},
         {{0, 1}, {0, 2}, {1, 2}}},
        {"a cross without a corner in the other", {box(0, 4, 9, 1), box(4, 0, 1, 9)}, {{0, 1}}},
        {"the whole grid, and its corners",
         {box(-FAR, -FAR, 2LL * FAR, 2LL * FAR), box(FAR, FAR, 0, 0), box(-FAR, FAR, 0, 0)},
         {{0, 1}, {0, 2}}},
        {"one unit apart across the whole grid",
         {box(-FAR, -FAR, 2LL * FAR - 1, 2LL * FAR), box(FAR, -FAR, 0, 2LL * FAR)},
         {}},
    };
    for (const auto& c : cases)
        for (Finder& find : all_finders())
            EXPECT_EQ(find(c.boxes), c.pairs) << c.what << ", " << find.name;
}

// Random boxes, tied positions, points, stacks, a grid whose boxes touch, the whole grid, slivers
// at its edges, clusters, sizes that differ a thousandfold, boxes one unit apart.
Boxes (*const WORLDS[])() = {
    [] { return random_world(300, 100'000, 10'000); },
    [] { return random_world(300, 8, 3); },
    [] { return random_world(300, 10, 0); },
    [] {
        Boxes boxes = random_world(100, 1000, 100);
        const std::size_t once = boxes.size();
        for (std::size_t i = 0; i < 2 * once; ++i) boxes.push_back(boxes[i % once]);
        return boxes;
    },
    [] {
        const auto columns = number(1, 20), side = number(0, FAR / 20);
        Boxes boxes;
        for (std::int64_t i = 0; i < 15 * columns; ++i)
            boxes.push_back(box(i % columns * side, i / columns * side, side, side));
        return boxes;
    },
    [] { return random_world(300, FAR, FAR); },
    [] {
        Boxes boxes = random_world(300, 3, 3);
        for (Aabb& b : boxes) {
            const auto edge = number(0, 3);
            if (edge == 0) b = {{-FAR, b.min.y}, {FAR, b.max.y}};
            if (edge == 1) b = {{b.min.x, -FAR}, {b.max.x, FAR}};
            if (edge == 2) b = {{FAR - 3, b.min.y}, {FAR, b.max.y}};
        }
        return boxes;
    },
    [] { return clustered_world(500); },
    [] { return heavy_tailed_world(500); },
    [] {
        const std::int64_t side = number(0, 100'000);
        Boxes boxes;
        for (int i = 0; i < 100; ++i) {
            const std::int64_t x = number(-9, 9), y = number(-9, 9);
            boxes.push_back(box(x * (side + 1) + number(-1, 0), y * (side + 1), side, side));
        }
        return boxes;
    },
};

TEST(BroadPhase, FindsWhatBruteForceFindsInWorldsOfAllKinds) {
    for (const auto world : WORLDS) EXPECT_TRUE(rc::check([world] { expect_all_agree(world()); }));
}

TEST(BroadPhase, AgreesWithBruteForceAmongTwoThousandBoxes) {
    for (const std::int64_t side : {100, 5'000, 50'000}) {
        std::mt19937 random(1);
        std::uniform_int_distribution<std::int64_t> place(-100'000, 100'000), sides(0, side);
        Boxes boxes;
        for (int i = 0; i < 2000; ++i)
            boxes.push_back(box(place(random), place(random), sides(random), sides(random)));
        const Sorted truth = brute_force(boxes);
        for (Finder& find : all_finders()) EXPECT_EQ(find(boxes), truth) << find.name;
    }
}

// Three nested worlds, each in a corner of the next, and tall boxes through all of them.
TEST(BroadPhase, FindsWhatBruteForceFindsInClustersWithinClusters) {
    std::mt19937 random(2);
    Boxes boxes;
    for (int i = 0; i < 2000; ++i) {
        const std::int64_t reach = std::int64_t{1} << (6 + i % 4 * 8);
        std::uniform_int_distribution<std::int64_t> place(0, reach), sides(0, reach / 20);
        boxes.push_back(box(place(random), place(random), sides(random), sides(random)));
        if (i % 40 == 0) boxes.back() = box(place(random), -FAR, 3, 2LL * FAR);
    }
    const Sorted truth = brute_force(boxes);
    for (Finder& find : all_finders()) EXPECT_EQ(find(boxes), truth) << find.name;
}

// ---- What must not matter ----

TEST(BroadPhase, RemembersNothingWrongFromTickToTick) {
    EXPECT_TRUE(rc::check([] {
        std::vector<Finder> finders = all_finders();
        Boxes boxes = random_world(300, 1000, 100);
        for (int tick = 0; tick < 10; ++tick) {
            const Sorted truth = brute_force(boxes);
            for (Finder& find : finders) RC_ASSERT(find(boxes) == truth);
            const auto change = number(0, 9);
            if (change == 0) boxes = random_world(300, FAR, FAR / 10);  // all others
            if (change == 1) boxes.resize(boxes.size() / 2);            // fewer
            if (change == 2) std::reverse(boxes.begin(), boxes.end());  // in another order
            if (change == 3)
                for (Aabb& b : boxes) std::swap(b.min.x, b.min.y), std::swap(b.max.x, b.max.y);
            const auto far = change == 4 ? 1000 : 5;
            for (Aabb& b : boxes) {
                const auto x = b.min.x + number(-far, far), y = b.min.y + number(-far, far);
                b = box(x, y, std::int64_t{b.max.x} - b.min.x, std::int64_t{b.max.y} - b.min.y);
            }
        }
    }));
}

}  // namespace
