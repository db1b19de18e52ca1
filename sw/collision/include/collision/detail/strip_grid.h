// strip_grid.h - boxes sorted into horizontal strips, and in each into buckets along x.
//
//     strip 2   |   +---+          A box is an entry of each strip that it reaches: at home in the
//               |...|.b.|.+---+.   lowest of them, a visitor in the others.  A pair belongs to the
//     strip 1   | +-+-+ | | c |    strip where one of the two is at home and the other one at home
//               | | a | +-|---|    or a visitor; there is exactly one: a-b and b-c to strip 1.
//     strip 0   |.+---+...+---+.
//
// Source: cell lists (Hockney and Eastwood, Computer Simulation Using Particles, 1981), here with
// cells that are long in one direction; a counting sort.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "collision/detail/kernels.h"
#include "collision/detail/sorted_boxes.h"

namespace collision::detail {

// Boxes of an array, given by entries: indices, with VISITOR_BIT or without.
struct BoxList {
    const Aabb* boxes;
    const std::uint32_t* entries;  // null: boxes 0, 1, 2 ...
    unsigned count;                // below 2^30

    std::uint32_t entry(unsigned i) const { return entries ? entries[i] : i; }
    Aabb box(unsigned i) const {
        const std::uint32_t entry = this->entry(i);
        Aabb box = boxes[entry & ~VISITOR_BIT];
        if (entry & VISITOR_BIT) box.min.y = VISITOR_MIN_Y;
        return box;
    }
};

// Strips between two y, of equal height to within 2^-16 of the whole.  A higher position is never
// in a lower strip.  Positions outside belong to the lowest or the highest strip.
struct StripScale {
    std::int32_t bottom, top;
    unsigned count, shift;
    std::uint32_t scale;

    // At most `wanted` strips, fewer where there are fewer units.  bottom <= top;
    // 0 < wanted < 2^16.
    StripScale(std::int32_t bottom, std::int32_t top, unsigned wanted);

    // The strip of a position `height` above the bottom.  It is computed in 32 bits, because
    // vectors have no wider product; so `shift` reduces a height to 16 bits.
    template <class Unsigned>
    Unsigned operator()(Unsigned height) const {
        return (height >> shift) * scale >> 16;
    }
};

class StripGrid {
public:
    struct Strip {
        std::uint32_t begin, end;  // in entries()
        bool even;                 // false: most boxes share a bucket with many others
    };

    // Sorts the boxes.  False, and no result, if there are more than MOST_VISITORS visitors per
    // box: call it with fewer strips then.  O(count + strips * buckets).
    bool sort(const Kernels& kernels, const BoxList& list, const StripScale& strips,
              const Buckets& buckets);

    static constexpr unsigned MOST_VISITORS = 2;

    // Valid until the next sort().  SLACK entries more may be read.
    const std::vector<Strip>& strips() const { return strips_; }
    const std::uint32_t* entries() const { return entries_.data(); }

    std::size_t bytes() const;  // of memory in use

private:
    std::vector<std::uint32_t> cells_;   // of each box: strip * buckets + bucket
    std::vector<std::uint32_t> above_;   // in how many strips above that is it a visitor?
    std::vector<std::uint32_t> tall_;    // the boxes for which this is not 0
    std::vector<std::uint32_t> places_;  // of each cell: its next place in entries_
    std::vector<std::uint32_t> entries_;
    std::vector<Strip> strips_;
};

}  // namespace collision::detail
