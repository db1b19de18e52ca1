// broad_phase_worlds.h - worlds of boxes, the broad phases, brute force.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "collision/broad_phase.h"

namespace tb {

using namespace collision;

// The same worlds on every run; set RC_PARAMS to look for others.
inline const bool SEEDED = setenv("RC_PARAMS", "seed=1 max_success=200", 0) == 0;

constexpr std::int32_t FAR = COORDINATE_LIMIT;

using Boxes = std::vector<Aabb>;
using Sorted = std::vector<CollisionPair>;

// ---- Brute force: a distance a pair and axis, in 64 bits ----

inline std::int64_t gap(std::int64_t min, std::int64_t max, std::int64_t other_min,
                        std::int64_t other_max) {
    return std::max(min - other_max, other_min - max);
}

inline Sorted brute_force(const Boxes& boxes) {
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

template <class Algorithm>
Finder finder(std::string name) {
    const auto algorithm = std::make_shared<Algorithm>();
    return {name, [algorithm](const Boxes& boxes, PairList& overlaps) {
                algorithm->find(boxes.data(), static_cast<unsigned>(boxes.size()), overlaps);
            }};
}

inline std::vector<Finder> all_finders() { return {finder<Sweep>("sweep"), finder<Simd>("simd")}; }

inline void expect_all_agree(const Boxes& boxes) {
    const Sorted truth = brute_force(boxes);
    for (Finder& find : all_finders()) RC_ASSERT(find(boxes) == truth);
}

// ---- Worlds ----

// Around `corner`, cut off where the grid ends.
inline Aabb box(std::int64_t x, std::int64_t y, std::int64_t width, std::int64_t height) {
    const auto on_grid = [](std::int64_t at) {
        return static_cast<std::int32_t>(std::clamp<std::int64_t>(at, -FAR, FAR));
    };
    return {{on_grid(x), on_grid(y)}, {on_grid(x + width), on_grid(y + height)}};
}

inline std::int64_t number(std::int64_t from, std::int64_t to) {
    return *rc::gen::inRange<std::int64_t>(from, to + 1);
}

// `most` boxes or fewer, with corners within `reach` of the middle and sides up to `side`.
inline Boxes random_world(int most, std::int64_t reach, std::int64_t side) {
    Boxes boxes(static_cast<std::size_t>(number(0, most)));
    for (Aabb& b : boxes)
        b = box(number(-reach, reach), number(-reach, reach), number(0, side), number(0, side));
    return boxes;
}

// Boxes around a few places, each with a scale of its own.
inline Boxes clustered_world(int most) {
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
inline Boxes heavy_tailed_world(int most) {
    Boxes boxes(static_cast<std::size_t>(number(0, most)));
    for (Aabb& b : boxes) {
        const auto width = 1000 / number(1, 1000), height = 1000 / number(1, 1000);
        b = box(number(-2000, 2000), number(-2000, 2000), width, height);
    }
    return boxes;
}

}  // namespace tb
