// algorithm.h - the algorithms by name.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace collision {

enum class Algorithm {
    ORIGINAL,            // original.h: the paper's Alg. 1 as told
    ORIGINAL_ALL_LINES,  // original.h: lines tested for every ordered pair
    ORIGINAL_BY_COPY,    // original.h: and polygons copied by value
    IMPROVED,            // improved.h: the paper's own, as told
    IMPROVED_VECTOR,     // improved.h: a vector in place of the linked list
    SWEEP,               // broad/sweep.h: one sorted axis, kept from tick to tick
    STRIPS,              // broad/strips.h: the one that scales
    SIMD,                // broad/simd.h: brute force by vectors, for few shapes
};

inline constexpr std::array ALGORITHMS = {
    Algorithm::ORIGINAL,         Algorithm::ORIGINAL_ALL_LINES,
    Algorithm::ORIGINAL_BY_COPY, Algorithm::IMPROVED,
    Algorithm::IMPROVED_VECTOR,  Algorithm::SWEEP,
    Algorithm::STRIPS,           Algorithm::SIMD};

// The fastest for up to some hundred shapes, and beyond, where it hands over to STRIPS.
inline constexpr Algorithm BEST = Algorithm::SIMD;

const char* name(Algorithm algorithm);  // "original_all_lines"

std::optional<Algorithm> algorithm_named(std::string_view name);  // exactly, in lower case

Algorithm next(Algorithm algorithm);  // after the last comes the first

}  // namespace collision
