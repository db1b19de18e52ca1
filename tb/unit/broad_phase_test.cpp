// broad_phase_test.cpp - sweep, strips and simd against brute force, on every kind of processor's
// kernels that this machine can run.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "collision/broad/simd.h"
#include "collision/broad/strips.h"
#include "collision/broad/sweep.h"

namespace {

using namespace collision;

// The same worlds on every run; set RC_PARAMS to look for others.
const bool SEEDED = setenv("RC_PARAMS", "seed=1 max_success=200", 0) == 0;

constexpr std::int32_t FAR = COORDINATE_LIMIT;

using Boxes = std::vector<Aabb>;
using Sorted = std::vector<CollisionPair>;

// ---- Brute force: a distance a pair and axis, in 64 bits ----

std::int64_t gap(std::int64_t min, std::int64_t max, std::int64_t other_min,
                 std::int64_t other_max) {
    return std::max(min - other_max, other_min - max);
}

Sorted brute_force(const Boxes& boxes) {
    Sorted pairs;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
            const Aabb &a = boxes[i], &b = boxes[j];
            if (gap(a.min.x, a.max.x, b.min.x, b.max.x) <= 0 &&
                gap(a.min.y, a.max.y, b.min.y, b.max.y) <= 0)
                pairs.push_back({i, j});
        }
    }
    return pairs;
}

// ---- The algorithms, in one list ----

// Whatever finds pairs, with the state it keeps from call to call.
struct Finder {
    std::string name;
    std::function<void(const Boxes&, PairList&)> find;

    // In order, but with duplicates, so that a pair found twice is seen.
    Sorted operator()(const Boxes& boxes) {
        find(boxes, list);
        Sorted pairs = list;
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }

    PairList list = {{77, 78}};  // to be forgotten
};

template <class Algorithm, class... Arguments>
Finder finder(std::string name, const Arguments&... arguments) {
    const auto algorithm = std::make_shared<Algorithm>(arguments...);
    return {name, [algorithm](const Boxes& boxes, PairList& overlaps) {
                algorithm->find(boxes.data(), static_cast<unsigned>(boxes.size()), overlaps);
            }};
}

std::vector<Finder> all_finders() {
    std::vector<Finder> finders;
    for (const Kernels* kernels : available_kernels()) {
        finders.push_back(finder<Sweep>(std::string("sweep, ") + kernels->name, *kernels));
        finders.push_back(finder<Simd>(std::string("simd, ") + kernels->name, *kernels));
        finders.push_back(finder<Strips>(std::string("strips, ") + kernels->name, *kernels));
    }
    return finders;
}

void expect_all_agree(const Boxes& boxes) {
    const Sorted truth = brute_force(boxes);
    for (Finder& find : all_finders()) RC_ASSERT(find(boxes) == truth);
}

// ---- Worlds ----

// Around `corner`, cut off where the grid ends.
Aabb box(std::int64_t x, std::int64_t y, std::int64_t width, std::int64_t height) {
    const auto on_grid = [](std::int64_t at) {
        return static_cast<std::int32_t>(std::clamp<std::int64_t>(at, -FAR, FAR));
    };
    return {{on_grid(x), on_grid(y)}, {on_grid(x + width), on_grid(y + height)}};
}

std::int64_t number(std::int64_t from, std::int64_t to) {
    return *rc::gen::inRange<std::int64_t>(from, to + 1);
}

// `most` boxes or fewer, with corners within `reach` of the middle and sides up to `side`.
Boxes random_world(int most, std::int64_t reach, std::int64_t side) {
    Boxes boxes(static_cast<std::size_t>(number(0, most)));
    for (Aabb& b : boxes)
        b = box(number(-reach, reach), number(-reach, reach), number(0, side), number(0, side));
    return boxes;
}

// Boxes around a few places, the sizes of which go with a world of their own each.
Boxes clustered_world(int most) {
    Boxes boxes(static_cast<std::size_t>(number(0, most)));
    const auto clusters = number(1, 6);
    std::vector<Aabb> places;
    for (int i = 0; i < clusters; ++i)
        places.push_back(
            box(number(-FAR, FAR), number(-FAR, FAR), number(0, 1000), number(0, FAR / 4)));
    for (Aabb& b : boxes) {
        const Aabb& place = places[static_cast<std::size_t>(number(0, clusters - 1))];
        const std::int64_t reach = place.max.y - place.min.y + 1;
        b = box(place.min.x + number(0, reach), place.min.y + number(0, reach),
                number(0, reach / 16), number(0, reach / 16));
    }
    return boxes;
}

// Sides from 1 to 1000 units, small ones far more often.
Boxes heavy_tailed_world(int most) {
    Boxes boxes(static_cast<std::size_t>(number(0, most)));
    for (Aabb& b : boxes) {
        const auto width = 1000 / number(1, 1000), height = 1000 / number(1, 1000);
        b = box(number(-2000, 2000), number(-2000, 2000), width, height);
    }
    return boxes;
}

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

TEST(BroadPhase, FindsWhatBruteForceFindsAmongRandomBoxes) {
    EXPECT_TRUE(rc::check([] { expect_all_agree(random_world(300, 100'000, 10'000)); }));
}

TEST(BroadPhase, FindsWhatBruteForceFindsWherePositionsTie) {
    EXPECT_TRUE(rc::check([] { expect_all_agree(random_world(300, 8, 3)); }));
}

TEST(BroadPhase, FindsWhatBruteForceFindsAmongPoints) {
    EXPECT_TRUE(rc::check([] { expect_all_agree(random_world(300, 10, 0)); }));
}

TEST(BroadPhase, FindsWhatBruteForceFindsInStacks) {
    EXPECT_TRUE(rc::check([] {
        Boxes boxes = random_world(100, 1000, 100);
        const std::size_t once = boxes.size();
        for (std::size_t i = 0; i < 2 * once; ++i) boxes.push_back(boxes[i % once]);
        expect_all_agree(boxes);
    }));
}

TEST(BroadPhase, FindsWhatBruteForceFindsWhereBoxesTouchInAGrid) {
    EXPECT_TRUE(rc::check([] {
        const auto columns = number(1, 20), side = number(0, FAR / 20);
        Boxes boxes;
        for (std::int64_t i = 0; i < 15 * columns; ++i)
            boxes.push_back(box(i % columns * side, i / columns * side, side, side));
        expect_all_agree(boxes);
    }));
}

TEST(BroadPhase, FindsWhatBruteForceFindsAllOverTheGrid) {
    EXPECT_TRUE(rc::check([] { expect_all_agree(random_world(300, FAR, FAR)); }));
}

TEST(BroadPhase, FindsWhatBruteForceFindsAmongSliversAtTheEdgesOfTheGrid) {
    EXPECT_TRUE(rc::check([] {
        Boxes boxes = random_world(300, 3, 3);
        for (Aabb& b : boxes) {
            const auto edge = number(0, 3);
            if (edge == 0) b = {{-FAR, b.min.y}, {FAR, b.max.y}};
            if (edge == 1) b = {{b.min.x, -FAR}, {b.max.x, FAR}};
            if (edge == 2) b = {{FAR - 3, b.min.y}, {FAR, b.max.y}};
        }
        expect_all_agree(boxes);
    }));
}

TEST(BroadPhase, FindsWhatBruteForceFindsInClusters) {
    EXPECT_TRUE(rc::check([] { expect_all_agree(clustered_world(500)); }));
}

TEST(BroadPhase, FindsWhatBruteForceFindsWhereSizesDifferAThousandfold) {
    EXPECT_TRUE(rc::check([] { expect_all_agree(heavy_tailed_world(500)); }));
}

TEST(BroadPhase, FindsWhatBruteForceFindsWhereEachPairIsOneUnitFromTouching) {
    EXPECT_TRUE(rc::check([] {
        const std::int64_t side = number(0, 100'000);
        Boxes boxes;
        for (int i = 0; i < 100; ++i) {
            const std::int64_t x = number(-9, 9), y = number(-9, 9);
            boxes.push_back(box(x * (side + 1) + number(-1, 0), y * (side + 1), side, side));
        }
        expect_all_agree(boxes);
    }));
}

TEST(BroadPhase, FindsWhatBruteForceFindsAmongTwoThousandOfAnySize) {
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

// A world in a corner of a world in a corner of a world, and tall boxes through all of them.
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

TEST(BroadPhase, DoesNotDependOnTheOrderOfTheBoxes) {
    EXPECT_TRUE(rc::check([] {
        const Boxes boxes = heavy_tailed_world(300);
        std::vector<std::uint32_t> from(boxes.size());
        std::iota(from.begin(), from.end(), 0u);
        for (std::size_t i = from.size(); i > 1; --i)
            std::swap(from[i - 1], from[*rc::gen::inRange<std::size_t>(0, i)]);
        Boxes shuffled;
        for (const std::uint32_t i : from) shuffled.push_back(boxes[i]);
        for (Finder& find : all_finders()) {
            Sorted back;
            for (const auto& [first, second] : find(shuffled))
                back.push_back(pair_of(from[first], from[second]));
            std::sort(back.begin(), back.end());
            RC_ASSERT(back == find(boxes));
        }
    }));
}

TEST(BroadPhase, SeesTheSameInAMirror) {
    EXPECT_TRUE(rc::check([] {
        const Boxes boxes = clustered_world(300);
        Boxes left_right, axes_exchanged;
        for (const auto& [min, max] : boxes) {
            left_right.push_back({{-max.x, min.y}, {-min.x, max.y}});
            axes_exchanged.push_back({{min.y, min.x}, {max.y, max.x}});
        }
        for (Finder& find : all_finders()) {
            const Sorted pairs = find(boxes);
            RC_ASSERT(find(left_right) == pairs);
            RC_ASSERT(find(axes_exchanged) == pairs);
        }
    }));
}

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

// As many as go through more than one level, heaped up tick by tick at the lower edge, then tall.
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

// So many that the world is cut into parts by a sample.  First all is even, then most boxes that no
// sample sees crowd in one place.
TEST(Strips, FindsAllPairsAmongMoreBoxesThanItSortsAtOnce) {
    std::mt19937 random(4);
    std::uniform_int_distribution<std::int64_t> place(0, FAR - 1), sides(0, 3'000'000);
    for (const bool even : {true, false}) {
        Boxes boxes;
        for (int i = 0; i < 150'000; ++i) {
            const bool sampled = i % 61 == 0 || i % 586 == 0;
            const std::int64_t y = even || sampled ? place(random) : FAR / 2 + place(random) / 16;
            boxes.push_back(box(place(random), y, sides(random), sides(random)));
        }
        const Sorted truth = sorted_sweep(boxes);
        for (const Kernels* kernels : available_kernels())
            EXPECT_EQ(finder<Strips>("strips", *kernels)(boxes), truth) << kernels->name;
    }
}

// Each tick all boxes to the right of `calm` are somewhere else there, and no others.
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
    const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl");
    const char* avx2_or_less = __builtin_cpu_supports("avx2") ? "AVX2" : "SSE2";
    EXPECT_STREQ(fastest_kernels().name, avx512 ? "AVX-512" : avx2_or_less);
}
#endif

TEST(Kernels, EndWithThePlainOnes) {
    const KernelList list = available_kernels();
    ASSERT_GE(list.count, 1u);
    EXPECT_STREQ(list.kernels[list.count - 1]->name, "plain");
    EXPECT_STREQ(list.kernels[0]->name, fastest_kernels().name);
}

}  // namespace
