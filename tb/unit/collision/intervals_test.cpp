// intervals_test.cpp - the paper's algorithm over any number of axes, against comparing all boxes.
#include "collision/intervals.h"

#include <vector>

#include "tb/unit/collision/worlds.h"

namespace {

using namespace worlds;

template <unsigned AXES>
std::vector<Box<AXES>> any_boxes(std::int32_t reach) {
    std::vector<Box<AXES>> boxes(static_cast<unsigned>(between(0, 40)));
    for (Box<AXES>& box : boxes)
        for (unsigned axis = 0; axis < AXES; ++axis) {
            box.min[axis] = between(-reach, reach);
            box.max[axis] = box.min[axis] + between(0, reach);
        }
    return boxes;
}

template <unsigned AXES>
PairList brute_force(const std::vector<Box<AXES>>& boxes) {
    PairList pairs;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
            bool overlap = true;
            for (unsigned axis = 0; axis < AXES; ++axis)
                overlap = overlap && boxes[i].max[axis] >= boxes[j].min[axis] &&
                          boxes[j].max[axis] >= boxes[i].min[axis];
            if (overlap) pairs.push_back({i, j});
        }
    return pairs;
}

template <class Axes>
class Overlapping : public testing::Test {};

template <unsigned N>
using Axes = std::integral_constant<unsigned, N>;
using AxesTested = testing::Types<Axes<1>, Axes<2>, Axes<3>, Axes<4>>;
TYPED_TEST_SUITE(Overlapping, AxesTested);

TYPED_TEST(Overlapping, FindsWhatBruteForceFinds) {
    constexpr unsigned AXES = TypeParam::value;
    EXPECT_TRUE(rc::check([] {
        for (const std::int32_t reach : {3, 20, COORDINATE_LIMIT / 2 - 1}) {
            const auto boxes = any_boxes<AXES>(reach);
            const PairList expected = brute_force(boxes);
            RC_ASSERT((overlapping<AXES, OpenList>(boxes) == expected));
            RC_ASSERT((overlapping<AXES, OpenVector>(boxes) == expected));
        }
    }));
}

TYPED_TEST(Overlapping, IsThatOfFewerAxesWhereAllBoxesAgreeOnTheLast) {
    constexpr unsigned AXES = TypeParam::value;
    EXPECT_TRUE(rc::check([] {
        const auto boxes = any_boxes<AXES>(10);
        std::vector<Box<AXES + 1>> deeper;
        for (const Box<AXES>& box : boxes) {
            Box<AXES + 1>& made = deeper.emplace_back();
            std::copy(box.min.begin(), box.min.end(), made.min.begin());
            std::copy(box.max.begin(), box.max.end(), made.max.begin());
            made.min[AXES] = -between(0, 5);
            made.max[AXES] = between(0, 5);
        }
        RC_ASSERT(overlapping<AXES + 1>(deeper) == overlapping<AXES>(boxes));
    }));
}

TEST(Overlapping, OnTwoAxesAgreesWithTheDetector) {
    EXPECT_TRUE(rc::check([] {
        const auto boxes = any_boxes<2>(30);
        Shapes shapes;
        for (const auto& [min, max] : boxes)  // their own outlines
            shapes.push_back(
                polygon({{min[0], min[1]}, {max[0], min[1]}, {max[0], max[1]}, {min[0], max[1]}}));
        PairList expected;
        for (const CollisionPair pair : overlapping<2>(boxes)) {
            const auto inside = [](const Box<2>& a, const Box<2>& b) {
                return a.min[0] > b.min[0] && a.max[0] < b.max[0] && a.min[1] > b.min[1] &&
                       a.max[1] < b.max[1];
            };
            const auto &a = boxes[pair.first], &b = boxes[pair.second];
            if (!inside(a, b) && !inside(b, a)) expected.push_back(pair);
        }
        RC_ASSERT(found(Algorithm::IMPROVED, shapes) == expected);
        RC_ASSERT(found(Algorithm::SIMD, shapes) == expected);
    }));
}

}  // namespace
