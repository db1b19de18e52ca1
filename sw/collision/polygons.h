// polygons.h - a view of an array of polygons, owned by the caller.
#pragma once

#include <cstddef>
#include <vector>

#include "collision/polygon.h"

namespace collision {

class Polygons {
public:
    Polygons(const Polygon* first, std::size_t count) : first_{first}, count_{count} {}
    Polygons(const std::vector<Polygon>& all) : Polygons{all.data(), all.size()} {}

    unsigned size() const { return static_cast<unsigned>(count_); }
    const Polygon& operator[](std::size_t i) const { return first_[i]; }

private:
    const Polygon* first_;
    std::size_t count_;
};

}  // namespace collision
