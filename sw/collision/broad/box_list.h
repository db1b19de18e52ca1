// box_list.h - boxes as they come, or with what they are called beside them.
#pragma once

#include <cstdint>
#include <limits>

#include "collision/polygon.h"

namespace collision {

// In place of min.y: the box also lies in a strip below.
constexpr std::int32_t VISITOR = std::numeric_limits<std::int32_t>::min();

// Beside an index: this box as a visitor.
constexpr std::uint32_t AS_VISITOR = 0x80000000;

// A box with its index, so that what is read together lies together.
struct Entry {
    Aabb box;  // min.y may be VISITOR
    std::uint32_t index;
};

// The same in a quarter of a cache line, for boxes of sides shorter than 2^16.
struct PackedEntry {
    Vec2 min;
    std::uint32_t sides;  // width, and height times 2^16
    std::uint32_t index;  // may be AS_VISITOR
};

// Not owned.  Fewer than 2^30, so that with their copies they can be counted in 32 bits.
struct BoxList {
    const Aabb* boxes;          // called 0, 1, 2 ..., or null
    const Entry* entries;       // or null
    const PackedEntry* packed;  // where both are null
    unsigned count;

    Aabb box(unsigned i) const { return boxes ? boxes[i] : entries ? entries[i].box : unpacked(i); }

    BoxList section(unsigned from, unsigned n) const;  // which calls its boxes 0, 1, 2 again

private:
    Aabb unpacked(unsigned i) const {
        const auto& [min, sides, index] = packed[i];
        const Vec2 max = {min.x + static_cast<std::int32_t>(sides & 0xffff),
                          min.y + static_cast<std::int32_t>(sides >> 16)};
        return {{min.x, index & AS_VISITOR ? VISITOR : min.y}, max};
    }
};

inline BoxList list_of(const Aabb* boxes, unsigned count) {
    return {boxes, nullptr, nullptr, count};
}
inline BoxList list_of(const Entry* entries, unsigned count) {
    return {nullptr, entries, nullptr, count};
}
inline BoxList list_of(const PackedEntry* packed, unsigned count) {
    return {nullptr, nullptr, packed, count};
}

inline BoxList BoxList::section(unsigned from, unsigned n) const {
    return boxes     ? list_of(boxes + from, n)
           : entries ? list_of(entries + from, n)
                     : list_of(packed + from, n);
}

}  // namespace collision
