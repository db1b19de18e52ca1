// short_boxes.cpp - see short_boxes.h
#include "collision/broad/short_boxes.h"

#include <algorithm>
#include <limits>

namespace collision {
namespace {

constexpr std::int32_t LAST = std::numeric_limits<std::int16_t>::max() - 1;

// From one axis of the world to -32768 .. LAST.
struct Scale {
    std::uint32_t origin;
    unsigned shift;

    Scale(std::int32_t min, std::int32_t max) : origin{static_cast<std::uint32_t>(min)}, shift{0} {
        constexpr std::uint32_t STEPS = LAST - std::numeric_limits<std::int16_t>::min();
        const std::uint32_t span = static_cast<std::uint32_t>(max) - origin;
        while (span >> shift > STEPS) ++shift;
    }

    std::int16_t operator()(std::int32_t at) const {
        const std::uint32_t steps = (static_cast<std::uint32_t>(at) - origin) >> shift;
        return static_cast<std::int16_t>(static_cast<std::int32_t>(steps) +
                                         std::numeric_limits<std::int16_t>::min());
    }
};

}  // namespace

void ShortBoxes::assign(const Aabb* boxes, unsigned count) {
    Aabb world = count ? boxes[0] : Aabb{};
    for (unsigned i = 1; i < count; ++i) {
        world.min.x = std::min(world.min.x, boxes[i].min.x);
        world.min.y = std::min(world.min.y, boxes[i].min.y);
        world.max.x = std::max(world.max.x, boxes[i].max.x);
        world.max.y = std::max(world.max.y, boxes[i].max.y);
    }
    const Scale x = {world.min.x, world.max.x}, y = {world.min.y, world.max.y};
    for (unsigned i = 0; i < count; ++i) {
        min_x[i] = x(boxes[i].min.x);
        min_y[i] = y(boxes[i].min.y);
        max_x[i] = x(boxes[i].max.x);
        max_y[i] = y(boxes[i].max.y);
    }
    // To the right of everything, where no box reaches.
    for (unsigned i = count; i < count + PADDING; ++i)
        min_x[i] = min_y[i] = max_x[i] = max_y[i] = LAST + 1;
}

}  // namespace collision
