// detector.cpp - see detector.h
#include "collision/detector.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>

#include "box_check.h"
#include "collision/grid.h"
#include "few.h"
#include "improved.h"
#include "narrow.h"
#include "original.h"

namespace collision {
namespace {

// What is wrong with polygons that did not pass the check.
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
Error copy_boxes(Polygons shapes, std::vector<Aabb>& boxes) {
    boxes.resize(shapes.size());
    BoxCheck check;
    for (unsigned i = 0; i < shapes.size(); ++i) {
        check.see(shapes[i]);
        boxes[i] = shapes[i].aabb;
    }
    return check.passed() ? Error::NONE : first_error(shapes);
}

}  // namespace

// Returns the end of those kept, which are written from `overlaps` on.
template <class Counter>
CollisionPair* BasicDetector<Counter>::keep(Polygons shapes, CollisionPair* overlaps,
                                            std::size_t count) {
    if constexpr (std::is_same_v<Counter, NoTally>) {
        return keep_meeting(shapes, overlaps, count, overlaps);
    } else {
        const auto apart = [&](CollisionPair pair) {
            counter.polygon_test();
            return !meet(shapes[pair.first], shapes[pair.second], counter);
        };
        return std::remove_if(overlaps, overlaps + count, apart);
    }
}

template <class Counter>
Error BasicDetector<Counter>::find_among_few(Polygons shapes, PairList& pairs) {
    Few few;
    if (!few.accept(shapes)) return first_error(shapes);
    std::array<CollisionPair, Few::MOST_PAIRS> found;
    if (const auto count = static_cast<std::size_t>(few.find(found.data()) - found.data()))
        pairs.assign(found.data(), keep(shapes, found.data(), count));
    return Error::NONE;
}

template <class Counter>
Error BasicDetector<Counter>::find(Algorithm algorithm, Polygons shapes, PairList& pairs) {
    pairs.clear();
    if (algorithm == Algorithm::SIMD && shapes.size() <= Few::CAPACITY)
        return find_among_few(shapes, pairs);
    if (const Error error = copy_boxes(shapes, boxes_); error != Error::NONE) return error;
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
        case Algorithm::SIMD: simd_.find(boxes_.data(), shapes.size(), overlaps_); break;
    }
    const CollisionPair* const end = keep(shapes, overlaps_.data(), overlaps_.size());
    pairs.assign(static_cast<const CollisionPair*>(overlaps_.data()), end);
    if (!std::is_sorted(pairs.begin(), pairs.end())) std::sort(pairs.begin(), pairs.end());
    return Error::NONE;
}

template class BasicDetector<NoTally>;
template class BasicDetector<Tally>;

}  // namespace collision
