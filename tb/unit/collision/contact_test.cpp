// contact_test.cpp - the point where two shapes meet.
#include "collision/contact.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "tb/unit/collision/truth.h"
#include "tb/unit/collision/worlds.h"

namespace {

using namespace worlds;
using truth::Wide;

// Is `point` within half a grid unit, on each axis, of a point of the line?  That is so if the unit
// square about the point meets the line; both are doubled to have integer corners.
bool near(Vec2 point, const Line& line) {
    const auto doubled = [](Vec2 at) { return Vec2{2 * at.x, 2 * at.y}; };
    const Line twice = {doubled(line.a), doubled(line.b)};
    const Vec2 p = doubled(point);
    const Vec2 corners[] = {
        {p.x - 1, p.y - 1}, {p.x + 1, p.y - 1}, {p.x + 1, p.y + 1}, {p.x - 1, p.y + 1}};
    for (unsigned i = 0; i < 4; ++i)
        if (truth::meet({corners[i], corners[(i + 1) % 4]}, twice)) return true;
    const auto inside = [&](Vec2 at) {
        return std::abs(std::int64_t{at.x} - p.x) <= 1 && std::abs(std::int64_t{at.y} - p.y) <= 1;
    };
    return inside(twice.a) && inside(twice.b);
}

bool near(Vec2 point, const Polygon& shape) {
    return std::any_of(shape.lines.begin(), shape.lines.begin() + shape.count,
                       [point](const Line& line) { return near(point, line); });
}

TEST(Contact, IsTheCrossingOfTwoLines) {
    EXPECT_EQ(contact(Line{{0, 0}, {10, 10}}, Line{{0, 10}, {10, 0}}), (Vec2{5, 5}));
    EXPECT_EQ(contact(Line{{0, 0}, {9, 3}}, Line{{3, -5}, {3, 5}}), (Vec2{3, 1}));
    EXPECT_EQ(contact(Line{{0, 0}, {0, 4}}, Line{{0, 4}, {7, 7}}), (Vec2{0, 4}));
    EXPECT_EQ(contact(Line{{-3, -3}, {3, 3}}, Line{{2, 2}, {2, 2}}), (Vec2{2, 2}));
    EXPECT_EQ(contact(Line{{0, 0}, {9, 9}}, Line{{1, 0}, {9, 8}}), std::nullopt);
}

TEST(Contact, IsRoundedToTheNearestUnitHalvesUp) {
    EXPECT_EQ(contact(Line{{0, 0}, {1, 1}}, Line{{0, 1}, {1, 0}}), (Vec2{1, 1}));
    EXPECT_EQ(contact(Line{{0, 0}, {-1, -1}}, Line{{0, -1}, {-1, 0}}), (Vec2{0, 0}));
    EXPECT_EQ(contact(Line{{0, 0}, {3, 3}}, Line{{-1, 1}, {1, 0}}), (Vec2{0, 0}));
}

TEST(Contact, OfCollinearLinesIsTheLeastPointInCommon) {
    EXPECT_EQ(contact(Line{{0, 0}, {8, 8}}, Line{{9, 9}, {5, 5}}), (Vec2{5, 5}));
    EXPECT_EQ(contact(Line{{4, 9}, {4, 1}}, Line{{4, 3}, {4, 20}}), (Vec2{4, 3}));
}

TEST(Contact, IsExactAtTheEndsOfTheGrid) {
    constexpr std::int32_t FAR = COORDINATE_LIMIT - 1;
    const Line rising = {{-FAR, -FAR}, {FAR, FAR}}, falling = {{-FAR, FAR}, {FAR, -FAR}};
    EXPECT_EQ(contact(rising, falling), (Vec2{0, 0}));
    EXPECT_EQ(contact(rising, Line{{FAR, FAR}, {FAR, -FAR}}), (Vec2{FAR, FAR}));
}

TEST(Contact, IsTheSameWhicheverWayLinesAndEndsAreNamed) {
    EXPECT_TRUE(rc::check([] {
        const std::int32_t reach = 1 << between(2, 29);
        const auto any = [reach] { return point({0, 0}, reach); };
        const Line p = {any(), any()}, q = {any(), any()};
        const auto expected = contact(p, q);
        const Line p_back = {p.b, p.a}, q_back = {q.b, q.a};
        RC_ASSERT(contact(q, p) == expected);
        RC_ASSERT(contact(p_back, q) == expected);
        RC_ASSERT(contact(q_back, p_back) == expected);
    }));
}

class ContactsIn : public testing::TestWithParam<Kind> {};

TEST_P(ContactsIn, AllWorldsLieOnBothShapes) {
    const auto make = GetParam().make;
    EXPECT_TRUE(rc::check([make] {
        const Shapes shapes = make();
        const PairList pairs = found(Algorithm::SIMD, shapes);
        std::vector<Contact> contacts;
        find_contacts(shapes, pairs, contacts);
        RC_ASSERT(contacts.size() == pairs.size());
        for (std::size_t i = 0; i < contacts.size(); ++i) {
            const auto& [pair, at] = contacts[i];
            RC_ASSERT(pair == pairs[i]);
            RC_ASSERT(near(at, shapes[pair.first]));
            RC_ASSERT(near(at, shapes[pair.second]));
        }
    }));
}

TEST_P(ContactsIn, AllWorldsAreIndependentOfOrder) {
    const auto make = GetParam().make;
    EXPECT_TRUE(rc::check([make] {
        Shapes shapes = make();
        for (const CollisionPair pair : found(Algorithm::SIMD, shapes)) {
            Polygon p = shapes[pair.first], q = shapes[pair.second];
            const auto expected = contact(p, q);
            std::reverse(p.lines.begin(), p.lines.begin() + p.count);
            for (Line& line : q.lines) std::swap(line.a, line.b);
            RC_ASSERT(contact(q, p) == expected);
        }
    }));
}

INSTANTIATE_TEST_SUITE_P(Worlds, ContactsIn, testing::ValuesIn(KINDS), name_of);

}  // namespace
