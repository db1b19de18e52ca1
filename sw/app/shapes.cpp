// shapes.cpp - see shapes.h
#include "app/shapes.h"

#include <cstddef>
#include <iterator>

namespace app {
namespace {

using collision::Vec2;

// Corners around the centre of a circle of radius RADIUS that no corner leaves; x to the right,
// y down.
constexpr std::int32_t RADIUS = 1024;

constexpr Vec2 SQUARE[] = {{724, 724}, {-724, 724}, {-724, -724}, {724, -724}};
constexpr Vec2 X[] = {{424, 0},  {904, 480},   {480, 904},   {0, 424},  {-480, 904}, {-904, 480},
                      {-424, 0}, {-904, -480}, {-480, -904}, {0, -424}, {480, -904}, {904, -480}};
constexpr Vec2 TRIANGLE[] = {{1024, 0}, {-512, 886}, {-512, -886}};
constexpr Vec2 PENTAGON[] = {{1024, 0}, {316, 973}, {-828, 601}, {-828, -601}, {316, -973}};
constexpr Vec2 ARROW[] = {{1024, 0}, {-724, 724}, {-300, 0}, {-724, -724}};
constexpr Vec2 STAR[] = {{1024, 0}, {316, 230},   {316, 973},   {-121, 372}, {-828, 601},
                         {-391, 0}, {-828, -601}, {-121, -372}, {316, -973}, {316, -230}};

struct Outline {
    const Vec2* corners;
    unsigned count;
};

template <std::size_t N>
constexpr Outline outline(const Vec2 (&corners)[N]) {
    static_assert(N <= collision::Polygon::MAX_LINES, "a shape of too many lines");
    return {corners, N};
}

// In the order of Shape.
constexpr Outline OUTLINES[] = {outline(SQUARE),   outline(X),     outline(TRIANGLE),
                                outline(PENTAGON), outline(ARROW), outline(STAR)};
static_assert(std::size(OUTLINES) == SHAPES, "a shape without an outline");

}  // namespace

collision::Polygon polygon(Shape shape, Vec2 centre, Angle angle, unsigned size) {
    const Outline& outline = OUTLINES[static_cast<std::size_t>(shape)];
    const std::int64_t cos = cosine(angle), sin = sine(angle);
    const auto scaled = [size](std::int64_t turned) {
        constexpr std::int64_t UNIT = std::int64_t{RADIUS} * SINE_ONE;
        return static_cast<std::int32_t>(turned * (size * collision::PIXEL / 2) / UNIT);
    };
    std::array<Vec2, collision::Polygon::MAX_LINES> corners;
    for (unsigned i = 0; i < outline.count; ++i) {
        const Vec2 corner = outline.corners[i];
        corners[i] = {centre.x + scaled(corner.x * cos - corner.y * sin),
                      centre.y + scaled(corner.x * sin + corner.y * cos)};
    }
    collision::Polygon placed;
    (void)placed.outline(corners.data(), outline.count);  // few enough, and on the screen
    return placed;
}

}  // namespace app
