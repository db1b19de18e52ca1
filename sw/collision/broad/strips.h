// strips.h - the broad phase that scales: cut the world into strips, sort each along x, sweep it.
//
//     strip 2   |   +---+          A box goes into each strip that it reaches, as a visitor into
//               |...|.b.|.+---+.   all but the lowest.  A pair belongs to the strip of the higher
//     strip 1   | +-+-+ | | c |    of the two lower edges, the only one that both reach and where
//               | | a | +-|---|    one is no visitor: a-b and b-c to strip 1.
//     strip 0   |.+---+...+---+.
//
// Strips are a few mean heights tall, so that most boxes lie in one or two of them whatever their
// sizes; where one still holds far more than its share, as in a cluster, it is cut in the same way.
// More boxes than the caches hold are first copied, strip by strip: 9 ns a box at a million where
// ten thousand take 6.5; 11 where a side is as long as 2^16, since all are then copied in full.
//
// Along x a strip is only sorted into buckets of a few boxes: a row is swept to the end of the
// bucket in which its box ends, and whether the two touch is asked in full.
//
// Source: cell lists (Hockney and Eastwood, Computer Simulation Using Particles, 1981) along one
// axis, sort and sweep (Baraff 1992) along the other.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/broad/kernels.h"
#include "collision/broad/packed_strip.h"
#include "collision/broad/strip_grid.h"
#include "collision/broad/world_parts.h"

namespace collision {

class Strips {
public:
    explicit Strips(const Kernels& kernels = fastest_kernels()) : kernels_{&kernels} {}

    // Clears `overlaps`, then fills it with every pair of boxes that overlap, touching included,
    // each once with first < second, in no particular order.  Exact for coordinates up to
    // COORDINATE_LIMIT; min <= max in every box; count < 2^30.  Remembers nothing but its memory.
    //
    // n boxes, k pairs: O(n + k) where neither tall nor wide boxes crowd a place without
    // overlapping there.  Allocates only when there are more boxes or pairs than ever before.
    void find(const Aabb* boxes, unsigned count, PairList& overlaps);

    // Of memory in use: 16 a box at 100,000 boxes spread evenly, 32 at a million, 39 where sides
    // reach 2^16, and at 1,000.
    std::size_t bytes() const;

private:
    void find(const BoxList& list, unsigned depth, PairRoom& room);
    void sweep(PairRoom& room);

    const Kernels* kernels_;
    std::vector<WorldParts> levels_;
    StripGrid grid_{*kernels_};
    PackedStrip packed_{*kernels_};
};

}  // namespace collision
