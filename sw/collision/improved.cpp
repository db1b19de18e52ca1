// improved.cpp - see improved.h
#include "collision/improved.h"

#include <algorithm>
#include <cstdint>
#include <forward_list>
#include <iterator>
#include <vector>

#include "collision/crossing.h"

namespace collision {
namespace {

// One end of a box on one axis.
struct Interval {
    const std::int32_t* position;
    bool opening;
    std::uint32_t index;  // of the shape

    // At one position openings come first: closed boxes that only touch overlap.
    bool operator<(const Interval& other) const {
        return *position != *other.position ? *position < *other.position
                                            : opening && !other.opening;
    }
};

// The newest is in front, where the one that closes next is likely to be.
void erase(std::forward_list<std::uint32_t>& open, std::uint32_t index) {
    auto before = open.before_begin();
    while (*std::next(before) != index) ++before;
    open.erase_after(before);
}

// The paper's getPossibleCollided(): all pairs whose intervals overlap on one axis.
Pairs possible_pairs(std::vector<Interval>& intervals) {
    Pairs pairs;
    std::forward_list<std::uint32_t> open;
    std::sort(intervals.begin(), intervals.end());
    for (const Interval& interval : intervals) {
        if (interval.opening) {
            for (const std::uint32_t other : open) pairs.insert(pair_of(interval.index, other));
            open.push_front(interval.index);
        } else {
            erase(open, interval.index);
        }
    }
    return pairs;
}

}  // namespace

Pairs find_improved(Polygons shapes) {
    std::vector<Interval> x_axis, y_axis;
    x_axis.reserve(2 * std::size_t{shapes.size()});
    y_axis.reserve(2 * std::size_t{shapes.size()});
    for (std::uint32_t i = 0; i < shapes.size(); ++i) {
        const Aabb& aabb = shapes[i].aabb;
        x_axis.push_back({&aabb.min.x, true, i});
        x_axis.push_back({&aabb.max.x, false, i});
        y_axis.push_back({&aabb.min.y, true, i});
        y_axis.push_back({&aabb.max.y, false, i});
    }
    const Pairs on_x = possible_pairs(x_axis), on_y = possible_pairs(y_axis);

    std::vector<CollisionPair> on_both;
    std::set_intersection(on_x.begin(), on_x.end(), on_y.begin(), on_y.end(),
                          std::back_inserter(on_both));
    Pairs pairs;
    for (const CollisionPair pair : on_both)
        if (cross(shapes[pair.first], shapes[pair.second])) pairs.insert(pairs.end(), pair);
    return pairs;
}

}  // namespace collision
