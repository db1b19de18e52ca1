// detect.cpp - see detect.h
#include "collision/detect.h"

#include <cstddef>
#include <iterator>

#include "collision/improved.h"
#include "collision/original.h"

namespace collision {
namespace {

struct Entry {
    const char* name;
    Pairs (*find)(Polygons);
};

// In the order of Algorithm.
constexpr Entry TABLE[] = {
    {"original", find_original},
    {"improved", find_improved},
};
static_assert(std::size(TABLE) == ALGORITHMS.size(), "an algorithm without an entry");

const Entry& entry(Algorithm algorithm) { return TABLE[static_cast<std::size_t>(algorithm)]; }

}  // namespace

const char* name(Algorithm algorithm) { return entry(algorithm).name; }

Algorithm next(Algorithm algorithm) {
    return ALGORITHMS[(static_cast<std::size_t>(algorithm) + 1) % ALGORITHMS.size()];
}

Pairs detect(Algorithm algorithm, Polygons shapes) { return entry(algorithm).find(shapes); }

}  // namespace collision
