// contact.cpp - see contact.h
#include "collision/contact.h"

#include <algorithm>
#include <cstdint>

#include "narrow.h"

namespace collision {
namespace {

bool before(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

std::uint64_t size(std::int64_t value) {
    return value < 0 ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
}

// start + way * part / whole, rounded to the nearest, halves up; 0 <= part <= whole < 2^63.
// Long division by bits, because the product takes 94 bits and the A9 has no 128-bit integers.
std::int32_t along(std::int32_t start, std::int64_t way, std::uint64_t part, std::uint64_t whole) {
    std::uint64_t quotient = 0, rest = 0;  // rest < whole, so that no sum reaches 2^64
    const std::uint64_t length = size(way);
    for (unsigned bit = 32; bit-- > 0;) {
        quotient *= 2;
        rest *= 2;
        if (rest >= whole) rest -= whole, ++quotient;
        if (length >> bit & 1) {
            rest += part;
            if (rest >= whole) rest -= whole, ++quotient;
        }
    }
    const bool half_or_more = way < 0 ? rest > whole - rest : rest >= whole - rest;
    const auto steps = static_cast<std::int64_t>(quotient + half_or_more);
    return static_cast<std::int32_t>(way < 0 ? start - steps : start + steps);
}

}  // namespace

std::optional<Vec2> contact(const Line& p, const Line& q) {
    if (!cross(p, q)) return std::nullopt;
    const std::int64_t from = side(q.a, q.b, p.a), to = side(q.a, q.b, p.b);
    if (from == to) {  // parallel, so collinear; or a point
        const Vec2 p_least = before(p.a, p.b) ? p.a : p.b, q_least = before(q.a, q.b) ? q.a : q.b;
        return before(p_least, q_least) ? q_least : p_least;
    }
    // p.a and p.b are on different sides of q: |from| + |to| is at most 2^63 - 2^34 + 8, as a
    // product of p's and q's ways.
    const std::uint64_t whole = size(from) + size(to);
    return Vec2{along(p.a.x, minus(p.b.x, p.a.x), size(from), whole),
                along(p.a.y, minus(p.b.y, p.a.y), size(from), whole)};
}

std::optional<Vec2> contact(const Polygon& p, const Polygon& q) {
    const Window window{intersection(p.aabb, q.aabb)};
    const unsigned p_lines = window.reached_by(p), q_lines = window.reached_by(q);
    std::optional<Vec2> least;
    any_line(p, p_lines, [&](const Line& of_p) {
        return any_line(q, q_lines, [&](const Line& of_q) {
            const std::optional<Vec2> point = contact(of_p, of_q);
            if (point && (!least || before(*point, *least))) least = point;
            return false;
        });
    });
    return least;
}

void find_contacts(Polygons shapes, const PairList& pairs, std::vector<Contact>& contacts) {
    contacts.clear();
    for (const CollisionPair pair : pairs)
        if (const auto point = contact(shapes[pair.first], shapes[pair.second]))
            contacts.push_back({pair, *point});
}

}  // namespace collision
