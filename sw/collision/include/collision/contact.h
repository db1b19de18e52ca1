// contact.h - where two polygons meet.  Beyond the paper, which only asks whether.
#pragma once

#include <optional>
#include <vector>

#include "collision/collision_pair.h"
#include "collision/polygon.h"

namespace collision {

struct Contact {
    CollisionPair pair;
    Vec2 point;  // grid units
};

// A point in common of two lines, or nothing if they do not meet: the crossing, each coordinate
// rounded to the nearest grid unit (halves up), so at most half a unit from either line on each
// axis; of collinear lines that overlap, the point in common with the least x, then y.
std::optional<Vec2> contact(const Line& p, const Line& q);

// The least of these points, by x, then y, over all lines of one and of the other: the same
// whichever polygon or line comes first.  O(lines x lines) of those that reach into the
// intersection of the boxes.
std::optional<Vec2> contact(const Polygon& p, const Polygon& q);

// Replaces `contacts` by one for each of `pairs`, in their order.  `pairs` are those that a
// Detector found among these shapes; any other pair that does not meet is left out.  Indices must
// exist.
void find_contacts(Polygons shapes, const PairList& pairs, std::vector<Contact>& contacts);

}  // namespace collision
