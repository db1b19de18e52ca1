// detect.h - all collision algorithms behind one call: same polygons, same pairs.
//
// A new algorithm is a line in Algorithm, a line in detect.cpp's table and a file of its own; the
// tests then hold it to the same answers as all others.
#pragma once

#include <array>

#include "collision/collision_pair.h"
#include "collision/polygons.h"

namespace collision {

enum class Algorithm { ORIGINAL, IMPROVED };

inline constexpr std::array ALGORITHMS = {Algorithm::ORIGINAL, Algorithm::IMPROVED};

const char* name(Algorithm algorithm);  // "original"

Algorithm next(Algorithm algorithm);  // after the last comes the first

// Every pair of polygons with lines that meet.  The boxes must be up to date: Polygon::update().
Pairs detect(Algorithm algorithm, Polygons shapes);

}  // namespace collision
