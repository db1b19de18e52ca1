// box_list.h - boxes as they come, or with what they are called beside them.
#pragma once

#include <cstdint>

#include "collision/polygon.h"

namespace collision {

// A box with its index, so that what is read together lies together.
struct Entry {
    Aabb box;  // min.y may be VISITOR
    std::uint32_t index;
};

// Not owned.  Fewer than 2^30, so that with their copies they can be counted in 32 bits.
struct BoxList {
    const Aabb* boxes;     // called 0, 1, 2 ..., or null
    const Entry* entries;  // where `boxes` is null
    unsigned count;

    const Aabb& box(unsigned i) const { return boxes ? boxes[i] : entries[i].box; }
    std::uint32_t index(unsigned i) const { return boxes ? i : entries[i].index; }

    BoxList section(unsigned from, unsigned n) const {  // which calls its boxes 0, 1, 2 again
        return {boxes ? boxes + from : nullptr, entries + (boxes ? 0 : from), n};
    }
};

[[gnu::always_inline]] inline const Aabb& box_of(const Aabb& box) { return box; }
[[gnu::always_inline]] inline const Aabb& box_of(const Entry& entry) { return entry.box; }

}  // namespace collision
