// broad_phase.h - axis-aligned boxes in, the pairs that overlap out: two algorithms.
//
// All have one call:
//
//     void find(const Aabb* boxes, unsigned count, PairList& overlaps);
//
// It replaces `overlaps` by every pair of boxes that overlap, touching included, each once with
// first < second, in no particular order.  Exact for coordinates up to COORDINATE_LIMIT; min <= max
// in every box; count < 2^30.  They differ in speed alone.  From call to call they keep their
// memory, and Sweep also its order; the boxes of two calls need not be related.  They allocate only
// when there are more boxes or pairs than ever before.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/collision_pair.h"
#include "collision/detail/short_boxes.h"
#include "collision/polygon.h"

namespace collision {

// Sort and sweep (also: sweep and prune).  Sort the boxes along one axis, then test each against
// those that begin within it:
//
//     |---a---|
//         |---b---|          a meets b and c on this axis, b meets c, d meets none
//            |--c--|
//                       |-d-|
//
// The axis is the one along which the boxes are spread more.  The order is kept from call to call:
// if boxes move little, insertion sort restores it in about one step per box.  If that turns out to
// be more work than a radix sort, it is given up early.
//
// n boxes, k pairs that overlap on the axis: O(n + k).  For n boxes all over a square, k is
// O(n sqrt(n)) at best.  43 bytes per box.
//
// Source: Baraff, "Dynamic simulation of non-penetrating rigid bodies" (1992); the choice of the
// axis is that of Ericson, Real-Time Collision Detection (2005), 7.5.2.
class Sweep {
public:
    void find(const Aabb* boxes, unsigned count, PairList& overlaps);

private:
    void choose_axis(const Aabb* boxes, unsigned count);
    std::uint64_t key(const Aabb& box, std::uint32_t index) const;
    void sort(const Aabb* boxes, unsigned count);
    bool repair(const Aabb* boxes);

    bool along_y_ = false;
    std::vector<std::uint64_t> keys_, spare_;  // positions with indices, in order
    std::vector<std::int32_t> edges_;          // of the boxes in that order, edge by edge
    std::vector<std::uint32_t> index_;         // the indices alone
};

// Brute force, eight boxes per vector of 16-bit coordinates.  It keeps no order and builds no
// structure, which is fastest for the number of shapes that fits on a screen.  From 71 boxes on
// with NEON, and 257 elsewhere, it calls Sweep, which is then faster.
//
// Idea: tests of quantised boxes, as in the leaves of quantised bounding volume trees (Terdiman,
// "Memory-optimized bounding-volume hierarchies", 2001); here without the tree.
class Simd {
public:
    void find(const Aabb* boxes, unsigned count, PairList& overlaps);

private:
    detail::ShortBoxes shorts_{};
    Sweep sweep_;
};

}  // namespace collision
