// broad_phase_test.cpp - sweep, strips and simd against brute force, on every kind of processor's
// kernels that this machine can run.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "collision/broad/simd.h"
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
    std::vector<Finder> finders = {finder<Sweep>("sweep")};
    for (const Kernels* kernels : available_kernels()) {
        finders.push_back(finder<Simd>(std::string("simd ") + kernels->name, *kernels));
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

// ---- Agreement with brute force ----

TEST(BroadPhase, FindsWhatBruteForceFindsAmongRandomBoxes) {
    EXPECT_TRUE(rc::check([] { expect_all_agree(random_world(300, 100'000, 10'000)); }));
}

}  // namespace
