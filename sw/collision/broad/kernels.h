// kernels.h - the inner loops of the broad phases, compiled once for each kind of processor.
//
// All give the same pairs; they differ in speed alone.  The algorithms take the fastest by default.
#pragma once

#include <cstddef>

#include "collision/broad/box_cells.h"
#include "collision/broad/box_list.h"
#include "collision/broad/fill_rows.h"
#include "collision/broad/packed_rows.h"
#include "collision/broad/pair_room.h"
#include "collision/broad/short_rows.h"
#include "collision/broad/strip_rows.h"

namespace collision {

struct Kernels {
    const char* name;  // "plain", "SSE2", "AVX2", "AVX-512", "NEON"

    unsigned strip_heights;  // of a strip, in mean heights of a box, that suits strip_rows

    // See the header of the same name.
    unsigned (*short_rows)(const ShortBoxes& shorts, unsigned count, unsigned row, ShortHits& hits);
    unsigned (*box_cells)(const BoxList& list, const GridParts& parts, std::uint32_t* cells,
                          std::uint32_t* tall);
    std::int32_t (*fill_rows)(const BoxList& list, const std::uint32_t* order, unsigned count,
                              const RowArrays& rows);
    void (*packed_buckets)(const PackedEntry* entries, unsigned count, const BucketParts& parts,
                           std::uint32_t* buckets);
    std::int32_t (*packed_rows)(const PackedEntry* entries, unsigned count, const RowArrays& rows);
    void (*strip_rows)(const StripRows& strip, PairRoom& room);
};

// Those that this machine can run, the fastest first: one to four.
struct KernelList {
    const Kernels* kernels[4];
    std::size_t count;

    const Kernels* const* begin() const { return kernels; }
    const Kernels* const* end() const { return kernels + count; }
};

KernelList available_kernels();

const Kernels& fastest_kernels();

}  // namespace collision
