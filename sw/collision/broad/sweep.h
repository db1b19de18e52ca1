// sweep.h - sort the boxes along one axis, then test each against those that begin within it.
//
//     |---a---|
//         |---b---|          a meets b and c on this axis, b meets c, d meets none
//            |--c--|
//                       |-d-|
//
// The order is kept from tick to tick: where boxes move little, insertion sort puts it right in
// about one step a box.
//
// Source: Baraff, "Dynamic simulation of non-penetrating rigid bodies" (1992), sort and sweep; the
// choice of the axis is that of Ericson, Real-Time Collision Detection (2005), 7.5.2.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/pair_list.h"
#include "collision/polygon.h"

namespace collision {

class Sweep {
public:
    // Clears `overlaps`, then fills it with every pair of boxes that overlap, touching included,
    // each once with first < second, in no particular order.  Exact for all int32 coordinates;
    // min <= max in every box.  The boxes of two calls need not have anything in common.
    //
    // n boxes, k pairs that overlap on the axis: O(n + k), plus the exchanges that the order takes;
    // beyond MOST_MOVES a box it is sorted anew in O(n).  For n boxes all over a square k is
    // O(n sqrt(n)) at best.  20 bytes a box, 36 after the first sort.
    void find(const Aabb* boxes, unsigned count, PairList& overlaps);

private:
    static constexpr unsigned MOST_MOVES = 8;

    struct Entry {
        std::int32_t min, max;            // on the axis
        std::int32_t side_min, side_max;  // on the other
        std::uint32_t index;
    };

    void choose_axis(const Aabb* boxes, unsigned count);
    Entry entry(const Aabb* boxes, std::uint32_t index) const;
    void sort(const Aabb* boxes, unsigned count);
    bool repair(const Aabb* boxes);

    bool along_y_ = false;
    std::vector<Entry> entries_;  // in the order of min
    std::vector<std::uint64_t> keys_, spare_;
};

}  // namespace collision
