// contender.h - a broad phase as the benchmark sees it: ours, or a peer's with its recommended use.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision/collision_pair.h"
#include "collision/polygon.h"

namespace bench {

using Boxes = std::vector<collision::Aabb>;

class Contender {
public:
    virtual ~Contender() = default;

    // Fills `pairs` with every pair of boxes that overlap, each once with first < second.  The
    // number of boxes is the same in all calls, and box i is always the same box, moved.
    virtual void tick(const Boxes& boxes, collision::PairList& pairs) = 0;
};

// A way to make one, so that each measurement begins with a new one.
struct Entry {
    std::string name;
    std::unique_ptr<Contender> (*make)();  // null: not installed
};

std::unique_ptr<Contender> strips();
std::unique_ptr<Contender> strips_anew();  // built anew in each tick
std::unique_ptr<Contender> sweep();
std::unique_ptr<Contender> sweep_anew();
std::unique_ptr<Contender> simd();

// Variants of each peer with different settings; the best one counts.  Empty: not installed.
std::vector<Entry> cgal();    // box_self_intersection_d, by cutoff
std::vector<Entry> bullet();  // btDbvtBroadphase, at once and deferred
std::vector<Entry> box2d();   // b2BroadPhase
std::vector<Entry> rtree();   // Boost.Geometry, bulk loaded

}  // namespace bench
