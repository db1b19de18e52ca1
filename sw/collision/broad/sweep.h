// sweep.h - sort the boxes along one axis, then test each against those that begin within it.
//
//     |---a---|
//         |---b---|          a meets b and c on this axis, b meets c, d meets none
//            |--c--|
//                       |-d-|
//
// The order is kept from tick to tick: where boxes move little, insertion sort puts it right in
// about one step a box.  Where they change places so often that sorting anew costs less, it gives
// up after the first few, so that a kept order is no slower than none.
//
// Source: Baraff, "Dynamic simulation of non-penetrating rigid bodies" (1992), sort and sweep; the
// choice of the axis is that of Ericson, Real-Time Collision Detection (2005), 7.5.2.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/broad/kernels.h"
#include "collision/broad/strip_grid.h"

namespace collision {

class Sweep {
public:
    explicit Sweep(const Kernels& kernels = fastest_kernels())
        : kernels_{&kernels}, sorted_{kernels} {}

    // Clears `overlaps`, then fills it with every pair of boxes that overlap, touching included,
    // each once with first < second, in no particular order.  Exact for coordinates up to
    // COORDINATE_LIMIT; min <= max in every box.  The boxes of two calls need not have anything in
    // common.
    //
    // n boxes, k pairs that overlap on the axis: O(n + k), a vector at a time, and so is the sort:
    // by insertion while no more than about one box in three is out of place so far, else by radix.
    // For n boxes all over a square k is O(n sqrt(n)) at best.  43 bytes a box.
    void find(const Aabb* boxes, unsigned count, PairList& overlaps);

private:
    static constexpr unsigned MOST_MOVES = 3;

    void choose_axis(const Aabb* boxes, unsigned count);
    std::uint64_t key(const Aabb& box, std::uint32_t index) const;
    void sort(const Aabb* boxes, unsigned count);
    bool repair(const Aabb* boxes);

    const Kernels* kernels_;
    bool along_y_ = false;
    std::vector<std::uint64_t> keys_, spare_;  // sort keys, kept in order from tick to tick
    StripGrid sorted_;                         // one strip of all
};

}  // namespace collision
