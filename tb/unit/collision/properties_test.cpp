// properties_test.cpp - every algorithm against brute force, on worlds of all kinds.
#include <algorithm>
#include <numeric>
#include <vector>

#include "collision/fixed_box.h"
#include "collision/grid.h"
#include "collision/turn.h"
#include "tb/unit/collision/truth.h"
#include "tb/unit/collision/worlds.h"

namespace {

using namespace worlds;

class EveryAlgorithm : public testing::TestWithParam<Kind> {
protected:
    // `property(algorithm, shapes, pairs)` for worlds of this kind and all algorithms.
    template <class Property>
    void holds(Property property) {
        const auto make = GetParam().make;
        EXPECT_TRUE(rc::check([make, property] {
            const Shapes shapes = make();
            for (const Algorithm algorithm : ALGORITHMS)
                property(algorithm, shapes, found(algorithm, shapes));
        }));
    }
};

TEST_P(EveryAlgorithm, FindsWhatBruteForceFinds) {
    const auto make = GetParam().make;
    EXPECT_TRUE(rc::check([make] {
        const Shapes shapes = make();
        const PairList expected = truth::pairs(shapes);
        for (const Algorithm algorithm : ALGORITHMS)
            RC_ASSERT(found(algorithm, shapes) == expected);
    }));
}

TEST_P(EveryAlgorithm, FindsEachPairOnceAndInOrder) {
    holds([](Algorithm, const Shapes& shapes, const PairList& pairs) {
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            RC_ASSERT(pairs[i].first < pairs[i].second);
            RC_ASSERT(pairs[i].second < shapes.size());
            if (i > 0) RC_ASSERT(pairs[i - 1] < pairs[i]);  // its || would read both sides
        }
    });
}

TEST_P(EveryAlgorithm, DoesNotDependOnTheOrderOfTheShapes) {
    holds([](Algorithm algorithm, const Shapes& shapes, const PairList& pairs) {
        std::vector<std::uint32_t> from(shapes.size());
        std::iota(from.begin(), from.end(), 0u);
        for (std::size_t i = from.size(); i > 1; --i)
            std::swap(from[i - 1],
                      from[static_cast<unsigned>(between(0, static_cast<int>(i) - 1))]);
        Shapes shuffled;
        for (const std::uint32_t i : from) shuffled.push_back(shapes[i]);
        PairList back;
        for (const auto& [first, second] : found(algorithm, shuffled))
            back.push_back(pair_of(from[first], from[second]));
        std::sort(back.begin(), back.end());
        RC_ASSERT(back == pairs);
    });
}

template <class Change>
Shapes changed(Shapes shapes, Change change) {
    for (Polygon& shape : shapes) {
        for (Line& line : shape.lines) line = {change(line.a), change(line.b)};
        shape.update();
    }
    return shapes;
}

TEST_P(EveryAlgorithm, SeesTheSameInAMirror) {
    holds([](Algorithm algorithm, const Shapes& shapes, const PairList& pairs) {
        const auto left_right = changed(shapes, [](Vec2 at) { return Vec2{-at.x, at.y}; });
        const auto diagonal = changed(shapes, [](Vec2 at) { return Vec2{at.y, at.x}; });
        RC_ASSERT(found(algorithm, left_right) == pairs);
        RC_ASSERT(found(algorithm, diagonal) == pairs);
    });
}

TEST_P(EveryAlgorithm, SeesTheSameWhereAllIsShifted) {
    holds([](Algorithm algorithm, const Shapes& shapes, const PairList& pairs) {
        Aabb all{};
        for (const Polygon& shape : shapes)
            all = {{std::min(all.min.x, shape.aabb.min.x), std::min(all.min.y, shape.aabb.min.y)},
                   {std::max(all.max.x, shape.aabb.max.x), std::max(all.max.y, shape.aabb.max.y)}};
        constexpr std::int32_t MOST = COORDINATE_LIMIT - 1;
        const Vec2 by = {between(-MOST - all.min.x, MOST - all.max.x),
                         between(-MOST - all.min.y, MOST - all.max.y)};
        Shapes shifted;
        for (const Polygon& shape : shapes) shifted.push_back(moved(shape, by));
        RC_ASSERT(found(algorithm, shifted) == pairs);
    });
}

TEST_P(EveryAlgorithm, FindsTheSameWithFixedBoxes) {
    holds([](Algorithm algorithm, const Shapes& shapes, const PairList& pairs) {
        Shapes boxed = shapes;
        for (Polygon& shape : boxed) {
            const auto& [min, max] = shape.aabb;
            const Vec2 centre = {min.x / 2 + max.x / 2, min.y / 2 + max.y / 2};
            if (fixed_box(shape, centre, shape.aabb) != Error::NONE) continue;  // reaches too far
        }
        RC_ASSERT(found(algorithm, boxed) == pairs);
    });
}

TEST_P(EveryAlgorithm, ForgetsTheTicksBefore) {
    const auto make = GetParam().make;
    EXPECT_TRUE(rc::check([make] {
        Detector detector;
        Shapes shapes = make();
        for (int tick = 0; tick < 4; ++tick) {
            const Vec2 step = point({0, 0}, 3);
            for (std::size_t i = 0; i < shapes.size(); i += 2) {
                const Polygon there = moved(shapes[i], step);
                if (on_grid(there.aabb.min) && on_grid(there.aabb.max)) shapes[i] = there;
            }
            if (tick == 2) shapes.resize(shapes.size() / 2);
            const PairList expected = truth::pairs(shapes);
            for (const Algorithm algorithm : ALGORITHMS) {
                PairList pairs;
                RC_ASSERT(detector.find(algorithm, shapes, pairs) == Error::NONE);
                RC_ASSERT(pairs == expected);
            }
        }
    }));
}

INSTANTIATE_TEST_SUITE_P(Worlds, EveryAlgorithm, testing::ValuesIn(KINDS), name_of);

TEST(EveryAlgorithm, FindsWhatBruteForceFindsAmongUpToTwoThousand) {
    for (const std::size_t count : {0u, 1u, 2u, 255u, 256u, 257u, 700u, 2000u}) {
        rc::Random random{count + 1};
        const auto below = [&random](std::uint64_t limit) {
            return static_cast<std::int32_t>(random.next() % limit);
        };
        Shapes shapes;
        while (shapes.size() < count)
            shapes.push_back(shapes.size() % 3 ? square(below(400), below(300), below(12))
                                               : x_shape(below(400), below(300)));
        const PairList expected = truth::pairs(shapes);
        for (const Algorithm algorithm : ALGORITHMS)
            EXPECT_EQ(found(algorithm, shapes), expected) << name(algorithm) << " of " << count;
    }
}

}  // namespace
