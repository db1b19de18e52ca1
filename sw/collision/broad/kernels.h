// kernels.h - the inner loops of the broad phases, compiled once for each kind of processor.
//
// All give the same pairs; they differ in speed alone.  The algorithms take the fastest by default.
#pragma once

#include <cstddef>

#include "collision/broad/pair_writer.h"
#include "collision/broad/short_boxes.h"
#include "collision/broad/strip_rows.h"

namespace collision {

struct Kernels {
    const char* name;  // "plain", "SSE2", "AVX2", "NEON"

    // Writes the overlapping pairs (row, j) with row < j < count, row by row from `row` on.  Stops
    // before a row that `room` may be too small for and returns it, or `count` at the end.
    // O(count^2 / lanes).
    unsigned (*short_rows)(const ShortBoxes& shorts, const Aabb* boxes, unsigned count,
                           unsigned row, PairRoom& room);

    unsigned (*strip_rows)(const StripRows& strip, unsigned row, PairRoom& room);
};

// Those that this machine can run, the fastest first: one to three.
struct KernelList {
    const Kernels* kernels[3];
    std::size_t count;

    const Kernels* const* begin() const { return kernels; }
    const Kernels* const* end() const { return kernels + count; }
};

KernelList available_kernels();

const Kernels& fastest_kernels();

}  // namespace collision
