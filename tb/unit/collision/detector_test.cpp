// detector_test.cpp - the library's one call: worlds worked out by hand, names, errors.
#include "collision/detector.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "tb/unit/collision/worlds.h"

namespace {

using namespace worlds;

struct WorldCase {
    const char* what;
    Shapes shapes;
    PairList pairs;
};

TEST(Detector, KnowsTheCasesWorkedOutByHand) {
    const Polygon nothing;
    const WorldCase cases[] = {
        {"no shapes", {}, {}},
        {"one shape does not collide with itself", {square(0, 0, 4)}, {}},
        {"corners that touch", {square(0, 0, 4), square(4, 4, 4)}, {{0, 1}}},
        {"sides that touch", {square(0, 0, 4), square(4, 1, 4)}, {{0, 1}}},
        {"one unit apart", {square(0, 0, 4), square(5, 0, 4)}, {}},
        {"one inside the other", {square(0, 0, 9), square(3, 3, 2)}, {}},
        {"one inside, touching a side", {square(0, 0, 9), square(3, 3, 6)}, {{0, 1}}},
        {"the same twice", {square(0, 0, 4), square(0, 0, 4)}, {{0, 1}}},
        {"three on one place",
         {square(0, 0, 4), square(0, 0, 4), square(0, 0, 4)},
         {{0, 1}, {0, 2}, {1, 2}}},
        {"X into X", {x_shape(0, 0), x_shape(4, 0)}, {{0, 1}}},
        {"in the notch of an X, touching nothing", {x_shape(0, 0), square(0, 2, 0)}, {}},
        {"in the notch of an X, touching its side", {x_shape(0, 0), square(0, 2, 1)}, {{0, 1}}},
        {"L around L, boxes overlapping",
         {polygon({{0, 0}, {9, 0}, {9, 1}, {1, 1}, {1, 9}, {0, 9}}), square(2, 2, 9)},
         {}},
        {"a chain: a-b and b-c, not a-c",
         {square(0, 0, 4), square(6, 0, 4), square(3, 1, 4)},
         {{0, 2}, {1, 2}}},
        {"on one axis only", {square(0, 0, 4), square(2, 9, 4), square(9, 2, 4)}, {}},
        {"a polygon of no lines", {nothing, square(-2, 0, 4), nothing}, {}},
    };
    for (const WorldCase& c : cases)
        for (const Algorithm algorithm : ALGORITHMS)
            EXPECT_EQ(found(algorithm, c.shapes), c.pairs) << c.what << ", " << name(algorithm);
}

// ---- Names ----

TEST(Algorithm, HasTheNameThatTheIssueGivesIt) {
    const char* const names[] = {"original", "original_all_lines", "original_by_copy",
                                 "improved", "improved_vector",    "sweep",
                                 "simd"};
    for (std::size_t i = 0; i < ALGORITHMS.size(); ++i) EXPECT_STREQ(name(ALGORITHMS[i]), names[i]);
}

TEST(Algorithm, IsFoundByItsNameAndByNoOther) {
    for (const Algorithm algorithm : ALGORITHMS)
        EXPECT_EQ(algorithm_named(name(algorithm)), algorithm);
    for (const char* const wrong : {"", "orig", "Original", "strips ", "best"})
        EXPECT_EQ(algorithm_named(wrong), std::nullopt) << wrong;
}

TEST(Algorithm, NextGoesRoundThemAll) {
    Algorithm algorithm = ALGORITHMS.front();
    std::set<Algorithm> seen;
    for (std::size_t i = 0; i < ALGORITHMS.size(); ++i) {
        seen.insert(algorithm);
        algorithm = next(algorithm);
    }
    EXPECT_EQ(seen.size(), ALGORITHMS.size());
    EXPECT_EQ(algorithm, ALGORITHMS.front());
}

// ---- Errors ----

// The middle one of three squares, made wrong, with all algorithms.
void expect_refused(const Polygon& wrong, Error error) {
    const Shapes shapes{square(0, 0, 4), wrong, square(2, 2, 4)};
    for (const Algorithm algorithm : ALGORITHMS) {
        PairList pairs{{7, 9}};
        Detector detector;
        EXPECT_EQ(detector.find(algorithm, shapes, pairs), error) << name(algorithm);
        EXPECT_TRUE(pairs.empty()) << name(algorithm);
    }
}

TEST(Detector, RefusesABoxBeyondTheGridOnAnySide) {
    for (const std::int32_t far : {COORDINATE_LIMIT, INT32_MAX}) {
        Polygon wrong = square(0, 0, 4);
        wrong.aabb.max.x = far;
        expect_refused(wrong, Error::OUTSIDE_GRID);
        wrong = square(0, 0, 4);
        wrong.aabb.max.y = far;
        expect_refused(wrong, Error::OUTSIDE_GRID);
    }
    for (const std::int32_t far : {-COORDINATE_LIMIT, INT32_MIN}) {
        Polygon wrong = square(0, 0, 4);
        wrong.aabb.min.x = far;
        expect_refused(wrong, Error::OUTSIDE_GRID);
        wrong = square(0, 0, 4);
        wrong.aabb.min.y = far;
        expect_refused(wrong, Error::OUTSIDE_GRID);
    }
}

TEST(Detector, AcceptsABoxToTheLastUnitOfTheGrid) {
    constexpr std::int32_t FAR = COORDINATE_LIMIT - 1;
    const Polygon all = polygon({{-FAR, -FAR}, {FAR, -FAR}, {FAR, FAR}, {-FAR, FAR}});
    for (const Algorithm algorithm : ALGORITHMS)
        EXPECT_EQ(found(algorithm, {all, square(0, 0, 4), square(FAR - 4, 0, 4)}),
                  (PairList{{0, 2}}));
}

TEST(Detector, RefusesABoxThatIsInsideOut) {
    Polygon wrong = square(0, 0, 4);
    wrong.aabb.min.x = 5;
    expect_refused(wrong, Error::BOX_INSIDE_OUT);
    wrong = square(0, 0, 4);
    wrong.aabb.max.y = -1;
    expect_refused(wrong, Error::BOX_INSIDE_OUT);
}

TEST(Detector, RefusesACountOfMoreLinesThanThereAre) {
    Polygon wrong = square(0, 0, 4);
    wrong.count = Polygon::MAX_LINES + 1;
    expect_refused(wrong, Error::TOO_MANY_LINES);
}

TEST(Error, HasAMessageOfItsOwn) {
    std::set<std::string> texts;
    for (const Error error : {Error::NONE, Error::NOT_FINITE, Error::OUTSIDE_GRID,
                              Error::TOO_MANY_LINES, Error::BOX_INSIDE_OUT})
        texts.insert(text(error));
    EXPECT_EQ(texts.size(), 5u);
}

TEST(CollisionPair, IsOrderedLikeWordsInADictionary) {
    EXPECT_LT((CollisionPair{1, 9}), (CollisionPair{2, 3}));
    EXPECT_LT((CollisionPair{1, 3}), (CollisionPair{1, 9}));
    EXPECT_FALSE((CollisionPair{1, 3} < CollisionPair{1, 3}));
    EXPECT_EQ(pair_of(7, 2), (CollisionPair{2, 7}));
}

}  // namespace
