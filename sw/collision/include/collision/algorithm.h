// algorithm.h - the algorithms by name.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace collision {

enum class Algorithm {
    ORIGINAL,            // the paper's Alg. 1 as described: every box against every other box
    ORIGINAL_ALL_LINES,  // and the lines of every ordered pair, whatever the boxes say
    ORIGINAL_BY_COPY,    // and polygons copied by value
    IMPROVED,            // the paper's own as described: sorted intervals on two axes (intervals.h)
    IMPROVED_VECTOR,     // and a vector in place of its linked list
    SWEEP,               // broad_phase.h: one sorted axis, kept from tick to tick
    SIMD,                // broad_phase.h: brute force by vectors, then SWEEP
};

inline constexpr std::array ALGORITHMS = {
    Algorithm::ORIGINAL, Algorithm::ORIGINAL_ALL_LINES, Algorithm::ORIGINAL_BY_COPY,
    Algorithm::IMPROVED, Algorithm::IMPROVED_VECTOR,    Algorithm::SWEEP,
    Algorithm::SIMD};

// The default: on the modelled Cortex-A9 it takes the fewest instructions of all.  Per tick:
//
//     squares      10       100       200
//     SIMD      1,800    50,800   179,000
//     SWEEP     3,700    50,800   179,000
inline constexpr Algorithm BEST = Algorithm::SIMD;

const char* name(Algorithm algorithm);  // "original_all_lines"

std::optional<Algorithm> algorithm_named(std::string_view name);  // exactly, in lower case

Algorithm next(Algorithm algorithm);  // after the last comes the first

}  // namespace collision
