// original.cpp - see original.h
#include "original.h"

#include <cstdint>
#include <set>
#include <vector>

#include "collision/crossing.h"

namespace collision {
namespace {

// Equations (1) and (3), or (2) and (4), on one axis.  Both sides are doubled, since a centre may
// lie between two grid points: 2 Len <= R_Width + R'_Width.
bool near_enough(std::int64_t min, std::int64_t max, std::int64_t other_min,
                 std::int64_t other_max) {
    const std::int64_t doubled_way = (min + max) - (other_min + other_max);
    const std::int64_t doubled_len = doubled_way < 0 ? -doubled_way : doubled_way;
    return doubled_len <= (max - min) + (other_max - other_min);
}

template <class Counter>
bool boxes_overlap(const Aabb& a, const Aabb& b, Counter& counter) {
    counter.box_test();
    return near_enough(a.min.x, a.max.x, b.min.x, b.max.x) &&
           near_enough(a.min.y, a.max.y, b.min.y, b.max.y);
}

// Fig. 2: each shape against each other one, from both sides.
template <class Colliding>
void each_with_each(std::uint32_t count, PairList& pairs, Colliding colliding) {
    std::set<CollisionPair> found;
    for (std::uint32_t i = 0; i < count; ++i)
        for (std::uint32_t j = 0; j < count; ++j)
            if (i != j && colliding(i, j)) found.insert(pair_of(i, j));
    pairs.assign(found.begin(), found.end());
}

struct VectorPolygon {
    std::vector<Line> lines;
    Aabb aabb;
};

// Not inlined, so that the caller really makes the copies.
template <class Counter>
[[gnu::noinline]] bool colliding_by_copy(VectorPolygon shape, VectorPolygon other,
                                         Counter& counter) {
    counter.copy();
    counter.copy();
    counter.polygon_test();
    bool meet = false;
    for (const Line& p : shape.lines) {
        for (const Line& q : other.lines) {
            counter.line_test();
            if ((meet = cross(p, q))) break;
        }
        if (meet) break;
    }
    return meet && boxes_overlap(shape.aabb, other.aabb, counter);
}

}  // namespace

template <class Counter>
void find_original(Polygons shapes, PairList& pairs, Counter& counter) {
    each_with_each(shapes.size(), pairs, [&](std::uint32_t i, std::uint32_t j) {
        if (!boxes_overlap(shapes[i].aabb, shapes[j].aabb, counter)) return false;
        counter.polygon_test();
        return cross(shapes[i], shapes[j], counter);
    });
}

template <class Counter>
void find_original_all_lines(Polygons shapes, PairList& pairs, Counter& counter) {
    each_with_each(shapes.size(), pairs, [&](std::uint32_t i, std::uint32_t j) {
        counter.polygon_test();
        return cross(shapes[i], shapes[j], counter) &&
               boxes_overlap(shapes[i].aabb, shapes[j].aabb, counter);
    });
}

template <class Counter>
void find_original_by_copy(Polygons shapes, PairList& pairs, Counter& counter) {
    std::vector<VectorPolygon> all(shapes.size());
    for (std::uint32_t i = 0; i < shapes.size(); ++i)
        all[i] = {{shapes[i].lines.begin(), shapes[i].lines.begin() + shapes[i].count},
                  shapes[i].aabb};
    each_with_each(shapes.size(), pairs, [&](std::uint32_t i, std::uint32_t j) {
        return colliding_by_copy(all[i], all[j], counter);
    });
}

template void find_original(Polygons, PairList&, Tally&);
template void find_original(Polygons, PairList&, NoTally&);
template void find_original_all_lines(Polygons, PairList&, Tally&);
template void find_original_all_lines(Polygons, PairList&, NoTally&);
template void find_original_by_copy(Polygons, PairList&, Tally&);
template void find_original_by_copy(Polygons, PairList&, NoTally&);

}  // namespace collision
