// broad_phase.h - axis-aligned boxes in, the pairs that overlap out: three algorithms.
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
#include "collision/detail/kernels.h"
#include "collision/detail/short_boxes.h"
#include "collision/detail/strip_grid.h"
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
    explicit Sweep(const detail::Kernels& kernels = detail::fastest_kernels())
        : kernels_{&kernels} {}

    void find(const Aabb* boxes, unsigned count, PairList& overlaps);

private:
    void choose_axis(const Aabb* boxes, unsigned count);
    std::uint64_t key(const Aabb& box, std::uint32_t index) const;
    void sort(const Aabb* boxes, unsigned count);
    bool repair(const Aabb* boxes);

    const detail::Kernels* kernels_;
    bool along_y_ = false;
    std::vector<std::uint64_t> keys_, spare_;  // positions with indices, in order
    std::vector<std::uint32_t> entries_;       // the indices alone
    detail::SortedBoxStore sorted_;
};

// A sweep in each of many strips: the algorithm that scales.  A strip is a few times as tall as the
// mean box.  In each strip the boxes are sorted into buckets along x and swept
// (detail/strip_grid.h).  A strip that is crowded is divided into strips again.
//
// n boxes, k pairs: O(n + k), unless many boxes lie close together without overlapping.
class Strips {
public:
    explicit Strips(const detail::Kernels& kernels = detail::fastest_kernels())
        : kernels_{&kernels} {}

    void find(const Aabb* boxes, unsigned count, PairList& overlaps);

    std::size_t bytes() const;  // of memory in use

private:
    void find(const detail::BoxList& list, unsigned depth, detail::PairWriter& pairs);
    void sweep_exactly(const detail::BoxList& strip, detail::PairWriter& pairs);

    const detail::Kernels* kernels_;
    std::vector<detail::StripGrid> levels_;  // a grid for each depth of strips within strips
    std::vector<std::uint64_t> keys_, spare_;
    std::vector<std::uint32_t> entries_;
    detail::SortedBoxStore sorted_;  // of one strip
};

// Brute force, eight or sixteen boxes per vector of 16-bit coordinates.  It keeps no order and
// builds no structure, which is fastest for the number of shapes that fits on a screen.  From 81
// boxes on with vectors of eight, or 257 with vectors of sixteen, it calls Strips, which is then
// faster.
//
// Idea: tests of quantised boxes, as in the leaves of quantised bounding volume trees (Terdiman,
// "Memory-optimized bounding-volume hierarchies", 2001); here without the tree.
class Simd {
public:
    explicit Simd(const detail::Kernels& kernels = detail::fastest_kernels())
        : kernels_{&kernels}, strips_{kernels} {}

    void find(const Aabb* boxes, unsigned count, PairList& overlaps);

private:
    const detail::Kernels* kernels_;
    detail::ShortBoxes shorts_{};
    detail::ShortHits hits_{};
    Strips strips_;
};

}  // namespace collision
