// detector.h - one call for all algorithms: same polygons, same pairs.
#pragma once

#include <vector>

#include "collision/algorithm.h"
#include "collision/broad_phase.h"
#include "collision/collision_pair.h"
#include "collision/error.h"
#include "collision/polygon.h"
#include "collision/tally.h"

namespace collision {

// Owns the buffers that SWEEP and SIMD keep from tick to tick: after the first ticks they
// allocate nothing.  Previous calls change the speed of a call, never its result.
template <class Counter>
class BasicDetector {
public:
    // Replaces `pairs` by all pairs of polygons whose lines meet (crossing.h), first < second, each
    // once, in lexicographic order.  `shapes` have boxes that contain their lines (polygon.h); any
    // number from 0 on.
    //
    // Refuses, in O(shapes) and before anything is compared, with `pairs` empty: TOO_MANY_LINES,
    // OUTSIDE_GRID, BOX_INSIDE_OUT, in this order of precedence.
    //
    // Cost: that of the algorithm (algorithm.h, broad_phase.h).  For SWEEP and SIMD also,
    // for each pair of overlapping boxes, O(lines) to leave out the lines that do not reach into
    // the intersection of the two boxes, then a test for each pair of those that are left.
    Error find(Algorithm algorithm, Polygons shapes, PairList& pairs);

    Counter counter;  // Tally: summed over all calls

private:
    Error find_among_few(Polygons shapes, PairList& pairs);
    CollisionPair* keep(Polygons shapes, CollisionPair* overlaps, std::size_t count);

    std::vector<Aabb> boxes_;
    PairList overlaps_;
    Sweep sweep_;
    Simd simd_;
};

using Detector = BasicDetector<NoTally>;
using CountingDetector = BasicDetector<Tally>;

}  // namespace collision
