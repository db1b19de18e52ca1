// kernels.h - the inner loops of the broad phases, compiled once for each kind of processor.
//
// All find the same pairs and differ in speed alone.  The broad phases use the fastest.
#pragma once

#include <cstdint>
#include <vector>

#include "collision/polygon.h"

namespace collision::detail {

class PairWriter;
struct BoxList;
struct Buckets;
struct ShortBoxes;
struct ShortHits;
struct SortedBoxes;
struct StripScale;

struct EdgeArrays {
    std::int32_t *min_x, *max_x, *min_y, *max_y;
    std::uint32_t* index;
};

struct Kernels {
    const char* name;  // "AVX2", "SSE2", "NEON", "plain"

    // Boxes up to which BruteForce is mostly faster than Strips, measured on the paper's workload.
    unsigned brute_force_up_to;

    // For each box of `list`: the cell in which it begins, strip * buckets.count + bucket, and how
    // many strips above that one it reaches.  Up to SLACK more numbers are written.
    void (*locate)(const BoxList& list, const StripScale& strips, const Buckets& buckets,
                   std::uint32_t* cells, std::uint32_t* above);

    // Copies the boxes that entries[0 .. count) name to one array for each edge; those of visitors
    // get VISITOR_MIN_Y.  Up to SLACK entries more are read and boxes written.
    void (*gather)(const Aabb* boxes, const std::uint32_t* entries, unsigned count,
                   const EdgeArrays& to);

    // Writes the pairs of each box with those after it.
    void (*sweep)(const SortedBoxes& boxes, PairWriter& pairs);

    // Compares each box from `row` on with those after it.  Stops before `hits` could overflow.
    // Returns the row to go on with, or `count` at the end.
    unsigned (*compare_all)(const ShortBoxes& boxes, unsigned count, unsigned row, ShortHits& hits);
};

// Those that this machine can run, the fastest first; the last one is "plain".
std::vector<const Kernels*> available_kernels();

const Kernels& fastest_kernels();

}  // namespace collision::detail
