// bounce.cpp - see bounce.h
#include "app/bounce.h"

#include <algorithm>
#include <cstdlib>

namespace app {
namespace {

using collision::Vec2;

std::int64_t divide_rounded(std::int64_t value, std::int64_t by) {
    return (value < 0 ? value - by / 2 : value + by / 2) / by;
}

std::int32_t limited(std::int64_t velocity) {
    return static_cast<std::int32_t>(
        std::clamp<std::int64_t>(velocity, -MAX_VELOCITY, MAX_VELOCITY));
}

}  // namespace

void bounce(Body& a, Body& b) {
    // From a to b in 1/64 pixel, which keeps the longest product below within 63 bits:
    // 2 * MAX_SIZE^2 * (2 * (2 * MAX_VELOCITY) * 2^12) * 2^12 < 2^63.
    constexpr std::int32_t STEP = collision::PIXEL / 64;
    std::int64_t x = (b.position.x - a.position.x) / STEP;
    const std::int64_t y = (b.position.y - a.position.y) / STEP;
    if (x == 0 && y == 0) x = 1;  // one on top of the other: any direction will do

    const std::int64_t apart =
        x * (b.velocity.x - a.velocity.x) + y * (b.velocity.y - a.velocity.y);
    if (apart < 0) {
        const std::int64_t by = (mass(a) + mass(b)) * (x * x + y * y);
        const std::int64_t to_a = 2 * mass(b) * apart, to_b = -2 * mass(a) * apart;
        a.velocity.x = limited(a.velocity.x + divide_rounded(to_a * x, by));
        a.velocity.y = limited(a.velocity.y + divide_rounded(to_a * y, by));
        b.velocity.x = limited(b.velocity.x + divide_rounded(to_b * x, by));
        b.velocity.y = limited(b.velocity.y + divide_rounded(to_b * y, by));
    }

    const std::int64_t longest = std::max(std::abs(x), std::abs(y));
    const Vec2 push = {static_cast<std::int32_t>(PUSH * x / longest),
                       static_cast<std::int32_t>(PUSH * y / longest)};
    a.position = {a.position.x - push.x, a.position.y - push.y};
    b.position = {b.position.x + push.x, b.position.y + push.y};
}

void bounce_off(Edge edge, Body& body) {
    const bool upright = edge == LEFT || edge == RIGHT;
    const std::int32_t inward = edge == LEFT || edge == TOP ? 1 : -1;
    std::int32_t& velocity = upright ? body.velocity.x : body.velocity.y;
    std::int32_t& position = upright ? body.position.x : body.position.y;
    velocity = inward * std::abs(velocity);
    position += inward * PUSH;
}

}  // namespace app
