// improved.cpp - see improved.h
#include "improved.h"

#include "collision/crossing.h"
#include "collision/intervals.h"

namespace collision {
namespace {

template <class Open, class Counter>
void find(Polygons shapes, PairList& pairs, Counter& counter) {
    struct Ends {
        const std::int32_t *min, *max;
    };
    const auto ends = [shapes](std::uint32_t i, unsigned axis) {
        const auto& [min, max] = shapes[i].aabb;
        return axis == 0 ? Ends{&min.x, &max.x} : Ends{&min.y, &max.y};
    };
    pairs.clear();
    for (const CollisionPair pair : overlapping<2, Open>(shapes.size(), ends, counter)) {
        counter.polygon_test();
        if (cross(shapes[pair.first], shapes[pair.second], counter)) pairs.push_back(pair);
    }
}

}  // namespace

template <class Counter>
void find_improved(Polygons shapes, PairList& pairs, Counter& counter) {
    find<OpenList>(shapes, pairs, counter);
}

template <class Counter>
void find_improved_vector(Polygons shapes, PairList& pairs, Counter& counter) {
    find<OpenVector>(shapes, pairs, counter);
}

template void find_improved(Polygons, PairList&, Tally&);
template void find_improved(Polygons, PairList&, NoTally&);
template void find_improved_vector(Polygons, PairList&, Tally&);
template void find_improved_vector(Polygons, PairList&, NoTally&);

}  // namespace collision
