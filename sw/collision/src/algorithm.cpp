// algorithm.cpp - see algorithm.h
#include "collision/algorithm.h"

#include <cstddef>

namespace collision {
namespace {

// In the order of Algorithm.
constexpr const char* NAMES[] = {"original", "original_all_lines", "original_by_copy",
                                 "improved", "improved_vector",    "sweep",
                                 "simd"};
static_assert(std::size(NAMES) == ALGORITHMS.size(), "an algorithm without a name");

}  // namespace

const char* name(Algorithm algorithm) { return NAMES[static_cast<std::size_t>(algorithm)]; }

std::optional<Algorithm> algorithm_named(std::string_view name_wanted) {
    for (const Algorithm algorithm : ALGORITHMS)
        if (name_wanted == name(algorithm)) return algorithm;
    return std::nullopt;
}

Algorithm next(Algorithm algorithm) {
    return ALGORITHMS[(static_cast<std::size_t>(algorithm) + 1) % ALGORITHMS.size()];
}

}  // namespace collision
