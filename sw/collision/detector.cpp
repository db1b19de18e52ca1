// detector.cpp - see detector.h
#include "collision/detector.h"

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "collision/few.h"
#include "collision/grid.h"
#include "collision/improved.h"
#include "collision/narrow.h"
#include "collision/original.h"

namespace collision {
namespace {

using Ints = BaseLanes::Ints;

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

// Copies the boxes to `boxes`, and names what is wrong with any.
Error take_boxes(Polygons shapes, Aabb* boxes) {
    constexpr std::int32_t LIMIT = COORDINATE_LIMIT;
    const Ints limit = {LIMIT, LIMIT, LIMIT, LIMIT};
    Ints wrong{};
    unsigned most_lines = 0;
    for (unsigned i = 0; i < shapes.size(); ++i) {
        const Ints box = lanes::load<Ints>(&shapes[i].aabb);
        // min where it is and max in place of it, so that min > max shows in two of the lanes.
        const Ints max = __builtin_shufflevector(box, box, 2, 3, 2, 3);
        wrong |= (box >= limit) | (box <= -limit) | (box > max);
        most_lines = std::max(most_lines, shapes[i].count);
        boxes[i] = shapes[i].aabb;
    }
    const bool right = BaseLanes::int_bits(wrong) == 0 && most_lines <= Polygon::MAX_LINES;
    return right ? Error::NONE : first_error(shapes);
}

}  // namespace

// Filters overlaps_ into `pairs`.
template <class Counter>
void BasicDetector<Counter>::keep_those_that_meet(Polygons shapes, PairList& pairs) {
    if constexpr (std::is_same_v<Counter, NoTally>) {
        pairs.resize(overlaps_.size());
        const auto end = keep_meeting_(shapes, overlaps_.data(), overlaps_.size(), pairs.data());
        pairs.resize(static_cast<std::size_t>(end - pairs.data()));
    } else {
        for (const CollisionPair pair : overlaps_) {
            counter.polygon_test();
            if (meet(shapes[pair.first], shapes[pair.second], counter)) pairs.push_back(pair);
        }
    }
    if (!std::is_sorted(pairs.begin(), pairs.end())) std::sort(pairs.begin(), pairs.end());
}

template <class Counter>
void BasicDetector<Counter>::find_few(PairList& overlaps) {
    Few few;
    few.assign(boxes_.data(), static_cast<unsigned>(boxes_.size()));
    std::array<CollisionPair, Few::MOST_PAIRS> found;
    overlaps.assign(found.data(), few.find(found.data()));
}

template <class Counter>
Error BasicDetector<Counter>::find(Algorithm algorithm, Polygons shapes, PairList& pairs) {
    pairs.clear();
    boxes_.resize(shapes.size());
    if (const Error error = take_boxes(shapes, boxes_.data()); error != Error::NONE) return error;
    switch (algorithm) {
        case Algorithm::ORIGINAL: find_original(shapes, pairs, counter); return Error::NONE;
        case Algorithm::ORIGINAL_ALL_LINES:
            find_original_all_lines(shapes, pairs, counter);
            return Error::NONE;
        case Algorithm::ORIGINAL_BY_COPY:
            find_original_by_copy(shapes, pairs, counter);
            return Error::NONE;
        case Algorithm::IMPROVED: find_improved(shapes, pairs, counter); return Error::NONE;
        case Algorithm::IMPROVED_VECTOR:
            find_improved_vector(shapes, pairs, counter);
            return Error::NONE;
        case Algorithm::SWEEP: sweep_.find(boxes_.data(), shapes.size(), overlaps_); break;
        case Algorithm::STRIPS: simd_.find(boxes_.data(), shapes.size(), overlaps_); break;
        case Algorithm::SIMD:
            if (shapes.size() <= Few::CAPACITY)
                find_few(overlaps_);
            else
                simd_.find(boxes_.data(), shapes.size(), overlaps_);
            break;
    }
    keep_those_that_meet(shapes, pairs);
    return Error::NONE;
}

template class BasicDetector<NoTally>;
template class BasicDetector<Tally>;

}  // namespace collision
