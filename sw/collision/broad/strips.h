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
//
// Source: cell lists (Hockney and Eastwood, Computer Simulation Using Particles, 1981) along one
// axis, sort and sweep (Baraff 1992) along the other.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/broad/kernels.h"
#include "collision/broad/strip_grid.h"

namespace collision {

class Strips {
public:
    explicit Strips(const Kernels& kernels = fastest_kernels()) : kernels_{&kernels} {}

    // Clears `overlaps`, then fills it with every pair of boxes that overlap, touching included,
    // each once with first < second, in no particular order.  Exact for coordinates up to
    // COORDINATE_LIMIT; min <= max in every box.  The same pairs whatever the call before, but up
    // to their order; after one for as many boxes spread alike over y, a pass over them is saved.
    //
    // n boxes, k pairs: O(n + k) where neither tall nor wide boxes crowd a place without
    // overlapping there.  Allocates only when there are more boxes or pairs than ever before.
    void find(const Aabb* boxes, unsigned count, PairList& overlaps);

    std::size_t bytes()
        const;  // of memory in use: 27 to 31 a box from 100,000 boxes on, 86 at 1,000

private:
    struct Level {
        std::vector<Entry> entries;         // strip by strip
        std::vector<std::uint32_t> places;  // of the next entry of each strip
        std::vector<std::uint32_t> starts;  // of each strip, and the end of the last

        // What the starts were made for: so many boxes, for which so many strips were wanted.
        unsigned count = 0, wanted = 0;
        StripOf strip_of = {0, 0, 1};

        bool suits(unsigned boxes, unsigned strips) const;
    };

    template <class Source>
    bool reserve(const Source& source, unsigned count, Level& level);
    template <class Source>
    bool scatter(const Source& source, unsigned count, Level& level);
    template <class Source>
    void find(const Source& source, unsigned count, unsigned depth, PairWriter& writer);
    void sweep(PairWriter& writer);

    const Kernels* kernels_;
    std::vector<Level> levels_;
    StripGrid grid_;
};

}  // namespace collision
