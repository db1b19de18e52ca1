// box_check.h - are polygons valid input of the algorithms?  Four coordinates at a time.
#pragma once

#include <algorithm>

#include "collision/polygon.h"
#include "four.h"

namespace collision {

// Call see() once for each polygon, then ask for the verdict.
class BoxCheck {
public:
    // Returns its box as a vector: min.x, min.y, max.x, max.y.
    Four see(const Polygon& polygon) {
        constexpr std::int32_t LIMIT = COORDINATE_LIMIT;
        const Four box = four(polygon.aabb);
        const Four limit = {LIMIT, LIMIT, LIMIT, LIMIT};
        // max in place of min, so that min > max shows in two of the lanes.
        const Four max = __builtin_shufflevector(box, box, 2, 3, 2, 3);
        wrong_ |= (box >= limit) | (box <= -limit) | (box > max);
        most_lines_ = std::max(most_lines_, polygon.count);
        return box;
    }

    bool passed() const { return !any(wrong_) && most_lines_ <= Polygon::MAX_LINES; }

private:
    Four wrong_{};
    unsigned most_lines_ = 0;
};

}  // namespace collision
