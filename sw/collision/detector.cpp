// detector.cpp - see detector.h
#include "collision/detector.h"

#include <algorithm>
#include <cstdint>

#include "collision/grid.h"
#include "collision/improved.h"
#include "collision/narrow.h"
#include "collision/original.h"

namespace collision {
namespace {

// Names what is wrong, once something is.
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

}  // namespace

template <class Counter>
Error BasicDetector<Counter>::take_boxes(Polygons shapes) {
    boxes_.resize(shapes.size());
    bool wrong = false;
    for (unsigned i = 0; i < shapes.size(); ++i) {
        const Aabb box = shapes[i].aabb;
        boxes_[i] = box;
        wrong |= (shapes[i].count > Polygon::MAX_LINES) | (box.min.x > box.max.x) |
                 (box.min.y > box.max.y) | (box.min.x <= -COORDINATE_LIMIT) |
                 (box.min.y <= -COORDINATE_LIMIT) | (box.max.x >= COORDINATE_LIMIT) |
                 (box.max.y >= COORDINATE_LIMIT);
    }
    return wrong ? first_error(shapes) : Error::NONE;
}

template <class Counter>
void BasicDetector<Counter>::keep_those_that_meet(Polygons shapes, PairList& pairs) {
    for (const CollisionPair pair : overlaps_) {
        counter.polygon_test();
        if (meet(shapes[pair.first], shapes[pair.second], counter)) pairs.push_back(pair);
    }
    if (!std::is_sorted(pairs.begin(), pairs.end())) std::sort(pairs.begin(), pairs.end());
}

template <class Counter>
Error BasicDetector<Counter>::find(Algorithm algorithm, Polygons shapes, PairList& pairs) {
    pairs.clear();
    if (const Error error = take_boxes(shapes); error != Error::NONE) return error;
    switch (algorithm) {
        case Algorithm::ORIGINAL: find_original(shapes, pairs, counter); break;
        case Algorithm::ORIGINAL_ALL_LINES: find_original_all_lines(shapes, pairs, counter); break;
        case Algorithm::ORIGINAL_BY_COPY: find_original_by_copy(shapes, pairs, counter); break;
        case Algorithm::IMPROVED: find_improved(shapes, pairs, counter); break;
        case Algorithm::IMPROVED_VECTOR: find_improved_vector(shapes, pairs, counter); break;
        case Algorithm::SWEEP:
            sweep_.find(boxes_.data(), shapes.size(), overlaps_);
            keep_those_that_meet(shapes, pairs);
            break;
        case Algorithm::STRIPS:
        case Algorithm::SIMD:
            simd_.find(boxes_.data(), shapes.size(), overlaps_);
            keep_those_that_meet(shapes, pairs);
            break;
    }
    return Error::NONE;
}

template class BasicDetector<NoTally>;
template class BasicDetector<Tally>;

}  // namespace collision
