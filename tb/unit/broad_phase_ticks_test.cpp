// broad_phase_ticks_test.cpp - what strips and sweep keep from tick to tick, worlds too large for
// brute force, and their cost.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <string>

#include "tb/unit/broad_phase_worlds.h"

namespace {

using namespace collision;
using namespace tb;

// Enough boxes for more than one level; they gather at the lower edge tick by tick, then become
// tall.
TEST(Strips, FindsTheSamePairsAsAnewWhereBoxesCrowdAfterTicksInWhichTheyDidNot) {
    std::mt19937 random(3);
    std::uniform_int_distribution<std::int64_t> place(0, 1'000'000), sides(0, 10'000);
    Strips kept;
    PairList found, anew;
    for (int tick = 0; tick < 8; ++tick) {
        Boxes boxes;
        for (int i = 0; i < 6000; ++i) {
            const std::int64_t y = i % 8 < tick && i % 300 != 0 ? place(random) / 8 : place(random);
            boxes.push_back(box(place(random), y, sides(random), sides(random)));
            if (tick == 7 && i % 2 == 0) boxes.back() = box(place(random), y, 10, 40'000);
        }
        const auto count = static_cast<unsigned>(boxes.size());
        kept.find(boxes.data(), count, found);
        Strips{}.find(boxes.data(), count, anew);
        std::sort(found.begin(), found.end());
        std::sort(anew.begin(), anew.end());
        EXPECT_EQ(found, anew) << "tick " << tick;
        EXPECT_EQ(found, brute_force(boxes)) << "tick " << tick;
    }
}

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

// First the boxes are spread evenly, then most crowd in one place.  Strips' sample of their places
// has none of those.
TEST(Strips, FindsAllPairsInALargeWorldThatItsSampleMisrepresents) {
    std::mt19937 random(4);
    std::uniform_int_distribution<std::int64_t> place(0, FAR - 1), sides(0, 3'000'000);
    for (const bool even : {true, false}) {
        Boxes boxes;
        for (int i = 0; i < 150'000; ++i) {
            const bool sampled = i % 244 < 4 || i % 586 == 0;
            const std::int64_t y = even || sampled ? place(random) : FAR / 2 + place(random) / 16;
            boxes.push_back(box(place(random), y, sides(random), sides(random)));
        }
        const Sorted truth = sorted_sweep(boxes);
        for (const Kernels* kernels : available_kernels())
            EXPECT_EQ(finder<Strips>("strips", *kernels)(boxes), truth) << kernels->name;
    }
}

// The sides are about 2^16, where 16 bits would no longer do.
TEST(Strips, FindsAllPairsInLargeWorldsWhereSidesAreAboutAsLongAs16BitsCount) {
    constexpr std::int32_t LONGEST = 65'535;
    std::mt19937 random(6);
    std::uniform_int_distribution<std::int64_t> place(-15'000'000, 15'000'000);
    std::uniform_int_distribution<std::int64_t> sides(LONGEST - 9, LONGEST);
    std::vector<Finder> finders;
    for (const Kernels* kernels : available_kernels())
        finders.push_back(finder<Strips>(kernels->name, *kernels));
    for (const Vec2 special :
         {Vec2{LONGEST, LONGEST}, {LONGEST + 1, 0}, {LONGEST, LONGEST}, {0, LONGEST + 1}, {0, 0}}) {
        Boxes boxes;
        for (int i = 0; i < 150'000; ++i) {
            boxes.push_back(box(place(random), place(random), sides(random), sides(random)));
            Aabb& b = boxes.back();
            if (i % 1000 == 999) b.max = {b.min.x + special.x, b.min.y + special.y};
        }
        const Sorted truth = sorted_sweep(boxes);
        for (Finder& find : finders)
            EXPECT_EQ(find(boxes), truth)
                << find.name << ", some of " << special.x << " x " << special.y;
    }
}

// Several lie beside each other in each bucket, in no order.
TEST(Strips, FindsAllPairsInLargeWorldsWhereBoxesAreNarrow) {
    std::mt19937 random(8);
    std::uniform_int_distribution<std::int64_t> place(-15'000'000, 15'000'000);
    std::uniform_int_distribution<std::int64_t> widths(0, 9), heights(30'000, 60'000);
    Boxes boxes;
    for (int i = 0; i < 150'000; ++i)
        boxes.push_back(box(place(random), place(random), widths(random), heights(random)));
    const Sorted truth = sorted_sweep(boxes);
    for (const Kernels* kernels : available_kernels())
        EXPECT_EQ(finder<Strips>("strips", *kernels)(boxes), truth) << kernels->name;
}

// In each tick all boxes to the right of `calm` get new places there; the others stay.
TEST(Sweep, FindsAllPairsWhereverItsOrderIsLost) {
    std::mt19937 random(5);
    std::uniform_int_distribution<std::int64_t> place(0, 1'000'000), sides(0, 10'000);
    Boxes boxes;
    for (int i = 0; i < 5000; ++i)
        boxes.push_back(box(place(random), place(random), sides(random), sides(random)));
    std::vector<Finder> finders;
    for (const Kernels* kernels : available_kernels())
        finders.push_back(finder<Sweep>(kernels->name, *kernels));
    for (const std::int64_t calm : {1'000'000, 999'000, 500'000, 2'000, 0}) {
        for (Aabb& b : boxes)
            if (b.min.x > calm)
                b = box(calm + 1 + place(random) % (1'000'000 - calm), b.min.y, 5'000, 5'000);
        const Sorted truth = sorted_sweep(boxes);
        for (Finder& find : finders)
            EXPECT_EQ(find(boxes), truth) << find.name << ", calm up to " << calm;
    }
}

// ---- What it takes ----

TEST(Strips, TakesLessThanAHundredBytesABoxWhereEveryBoxIsTall) {
    Boxes boxes;
    for (int i = 0; i < 100'000; ++i) boxes.push_back(box(i * 10, i % 1000 * 20, 5, 20'000));
    Strips strips;
    PairList overlaps;
    strips.find(boxes.data(), static_cast<unsigned>(boxes.size()), overlaps);
    EXPECT_LT(strips.bytes(), 100 * boxes.size());
}

#if defined(__x86_64__)
TEST(Kernels, AreTheWidestThatTheProcessorHas) {
    EXPECT_STREQ(detail::fastest_kernels().name, __builtin_cpu_supports("avx2") ? "AVX2" : "SSE2");
}
#endif

// The other tests use the kernels that this processor can run.  Each kernel is named here, so that
// it shows which ones were not tested.
class KernelsFor : public ::testing::TestWithParam<const char*> {};

TEST_P(KernelsFor, ThisProcessorAreTested) {
    const std::vector<const Kernels*> list = available_kernels();
    const bool there = std::any_of(list.begin(), list.end(), [](const Kernels* kernels) {
        return std::string{kernels->name} == GetParam();
    });
    if (!there) GTEST_SKIP() << GetParam() << " kernels: not tested, this processor has no such";
}

#if defined(__x86_64__)
INSTANTIATE_TEST_SUITE_P(X86, KernelsFor, ::testing::Values("AVX2", "SSE2"),
                         [](const auto& kernels) { return std::string{kernels.param}; });
#endif
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(KernelsFor);

TEST(Kernels, EndWithThePlainOnes) {
    const std::vector<const Kernels*> list = available_kernels();
    ASSERT_FALSE(list.empty());
    EXPECT_STREQ(list.back()->name, "plain");
    EXPECT_EQ(list.front(), &detail::fastest_kernels());
}

}  // namespace
