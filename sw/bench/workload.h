// workload.h - the paper's shapes on its screen, as a film of ticks.
#pragma once

#include <cstdint>
#include <vector>

#include "app/shapes.h"
#include "collision/polygon.h"

namespace bench {

struct Workload {
    app::Shape shape;
    unsigned
        inserted;   // and the four edges of the screen: "inserting 1 shape makes 5 shapes total"
    unsigned size;  // pixels across
};

using Tick = std::vector<collision::Polygon>;

// `ticks` ticks of shapes that fly about on 320 x 240 pixels, turn, and bounce off the edges, but
// not off each other.  For more than 200 shapes the screen grows, so that they are as dense as 200.
// The same arguments give the same film.
std::vector<Tick> film(const Workload& workload, unsigned ticks);

}  // namespace bench
