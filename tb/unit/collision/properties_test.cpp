// properties_test.cpp - every algorithm against brute force, on worlds of all kinds.
#include <algorithm>
#include <vector>

#include "collision/fixed_box.h"
#include "collision/grid.h"
#include "collision/turn.h"
#include "tb/unit/collision/truth.h"
#include "tb/unit/collision/worlds.h"

namespace {

using namespace worlds;

class EveryAlgorithm : public testing::TestWithParam<Kind> {};

TEST_P(EveryAlgorithm, FindsWhatBruteForceFinds) {
    const auto make = GetParam().make;
    EXPECT_TRUE(rc::check([make] {
        const Shapes shapes = make();
        const PairList expected = truth::pairs(shapes);
        for (const Algorithm algorithm : ALGORITHMS)
            RC_ASSERT(found(algorithm, shapes) == expected);
    }));
}

TEST_P(EveryAlgorithm, FindsTheSameWithFixedBoxes) {
    const auto make = GetParam().make;
    EXPECT_TRUE(rc::check([make] {
        const Shapes shapes = make();
        const PairList expected = truth::pairs(shapes);
        Shapes boxed = shapes;
        for (Polygon& shape : boxed) {
            const auto& [min, max] = shape.aabb;
            const Vec2 centre = {min.x / 2 + max.x / 2, min.y / 2 + max.y / 2};
            if (fixed_box(shape, centre, shape.aabb) != Error::NONE) continue;  // reaches too far
        }
        for (const Algorithm algorithm : ALGORITHMS) RC_ASSERT(found(algorithm, boxed) == expected);
    }));
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
