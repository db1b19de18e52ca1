// simd.h - brute force over 16-bit fixed-point boxes, eight or sixteen a vector.
//
// For the number of shapes that fits a screen: there is no order to keep and nothing to build,
// and a hundred boxes are 4,950 pairs in some 700 vectors.
//
// Idea: all-pairs tests on quantised boxes, as in the leaves of quantised bounding volume trees
// (Terdiman, "Memory-optimized bounding-volume hierarchies", 2001); here without the tree.
#pragma once

#include "collision/broad/kernels.h"
#include "collision/broad/strips.h"

namespace collision {

class Simd {
public:
    static constexpr unsigned CAPACITY = ShortBoxes::CAPACITY;

    explicit Simd(const Kernels& kernels = fastest_kernels())
        : kernels_{&kernels}, strips_{kernels} {}

    // Clears `overlaps`, then fills it with every pair of boxes that overlap, touching included,
    // each once with first < second, in no particular order.  Exact for coordinates up to
    // COORDINATE_LIMIT.  More than CAPACITY boxes are left to Strips.  O(count^2 / lanes) up to
    // CAPACITY; allocates only when there are more pairs than `overlaps` has ever held.
    void find(const Aabb* boxes, unsigned count, PairList& overlaps);

private:
    static constexpr unsigned MOST_IN_HIT = 16;  // lanes
    static constexpr unsigned FEW = 12;          // boxes that vectors do not pay for

    void append(const Aabb* boxes, const ShortHit& hit, PairRoom& room) const;

    const Kernels* kernels_;
    ShortBoxes shorts_{};
    ShortHits hits_{};
    Strips strips_;
};

}  // namespace collision
