// box_check.cpp - see box_check.h
#include "collision/box_check.h"

#include "collision/grid.h"

namespace collision {

Error first_error(Polygons shapes) {
    Error found = Error::NONE;
    for (unsigned i = 0; i < shapes.size(); ++i) {
        const auto& [min, max] = shapes[i].aabb;
        if (shapes[i].count > Polygon::MAX_LINES) return Error::TOO_MANY_LINES;
        if (!on_grid(min) || !on_grid(max)) found = Error::OUTSIDE_GRID;
        if ((min.x > max.x || min.y > max.y) && found == Error::NONE) found = Error::BOX_INSIDE_OUT;
    }
    return found;
}

}  // namespace collision
