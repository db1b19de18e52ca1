// pack.h - what WorldParts writes for a box: the short entry, or the one for sides of any length.
#pragma once

#include "collision/broad/box_list.h"
#include "collision/four.h"

namespace collision {

// Whether all sides were short.  No branch: it is known at the end.
class ShortSides {
public:
    // Width and height, then both less than 0.
    Four operator()(const Aabb& box) {
        using Unsigned [[gnu::vector_size(16)]] = std::uint32_t;  // 2^31 at most
        const auto from = reinterpret_cast<Unsigned>(four(box));
        const auto to = reinterpret_cast<Unsigned>(exchanged(four(box)));
        const Four sides = reinterpret_cast<Four>(to - from);
        all_ |= sides;
        return sides;
    }
    bool all_short() const { return static_cast<std::uint32_t>(all_[0] | all_[1]) < 1u << 16; }

private:
    Four all_ = {};
};

// Looks at the sides, too, so that the next time they may be packed.
struct Unpacked {
    using Written = Entry;
    static constexpr bool ANY_SIDES = true;

    static const Entry* written(const BoxList& list) { return list.entries; }
    static Entry visitor(Entry entry) {
        entry.box.min.y = VISITOR;
        return entry;
    }
    Entry operator()(const Aabb* boxes, unsigned i) {
        sides(boxes[i]);
        return {boxes[i], i};
    }
    Entry operator()(const Entry* entries, unsigned i) { return entries[i]; }

    ShortSides sides;
};

struct Packed {
    using Written = PackedEntry;
    static constexpr bool ANY_SIDES = false;

    static const PackedEntry* written(const BoxList& list) { return list.packed; }
    static PackedEntry visitor(PackedEntry entry) {
        entry.index |= AS_VISITOR;
        return entry;
    }
    PackedEntry operator()(const Aabb* boxes, unsigned i) {
        using Shorts [[gnu::vector_size(16)]] = std::int16_t;
        const auto shorts = reinterpret_cast<Shorts>(sides(boxes[i]));
        const auto packed =
            reinterpret_cast<Four>(__builtin_shufflevector(shorts, shorts, 0, 2, 2, 2, 4, 5, 6, 7));
        const Four index = {static_cast<std::int32_t>(i), 0, 0, 0};
        const Four upper = __builtin_shufflevector(packed, index, 0, 4, 1, 5);
        const Four all = __builtin_shufflevector(four(boxes[i]), upper, 0, 1, 4, 5);
        PackedEntry entry;
        std::memcpy(static_cast<void*>(&entry), &all, sizeof entry);
        return entry;
    }
    PackedEntry operator()(const PackedEntry* entries, unsigned i) { return entries[i]; }

    ShortSides sides;
};

}  // namespace collision
