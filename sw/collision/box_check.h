// box_check.h - are polygons such that the algorithms can take them?  Four coordinates at a time.
#pragma once

#include <algorithm>

#include "collision/polygons.h"
#include "collision/window.h"

namespace collision {

// See each polygon once, then ask.
class BoxCheck {
public:
    // Returns its box as a vector: min.x, min.y, max.x, max.y.
    BaseLanes::Ints see(const Polygon& polygon) {
        constexpr std::int32_t LIMIT = COORDINATE_LIMIT;
        const Ints box = lanes::load<Ints>(&polygon.aabb);
        const Ints limit = {LIMIT, LIMIT, LIMIT, LIMIT};
        // max in place of min, so that min > max shows in two of the lanes.
        const Ints max = __builtin_shufflevector(box, box, 2, 3, 2, 3);
        wrong_ |= (box >= limit) | (box <= -limit) | (box > max);
        most_lines_ = std::max(most_lines_, polygon.count);
        return box;
    }

    bool passed() const {
        return BaseLanes::int_bits(wrong_) == 0 && most_lines_ <= Polygon::MAX_LINES;
    }

private:
    using Ints = BaseLanes::Ints;

    Ints wrong_{};
    unsigned most_lines_ = 0;
};

// What is wrong with polygons that did not pass.
Error first_error(Polygons shapes);

}  // namespace collision
