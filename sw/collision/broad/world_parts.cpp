// world_parts.cpp - see world_parts.h
#include "collision/broad/world_parts.h"

#include "collision/broad/fill_rows.h"

namespace collision {

// Where each part begins, without a look at those between the first and the last that a box
// reaches.  False if there are too many copies.
bool WorldParts::measure(const BoxList& list, const StripParts& parts) {
    const StripParts part_of =
        parts;  // a copy, or each count that is written might have changed it
    std::vector<std::uint32_t>& more = ends_;  // than in the part before, modulo 2^32
    more.assign(part_of.count + 1, 0);
    for (unsigned i = 0; i < list.count; ++i) {
        const Aabb& box = list.box(i);
        ++more[part_of(box.min.y)];
        --more[part_of(box.max.y) + 1];
    }
    std::uint64_t start = 0;
    std::uint32_t in_part = 0;
    for (std::uint32_t& at : ends_) {
        in_part += at;
        at = static_cast<std::uint32_t>(start);
        start += in_part;
    }
    ends_.pop_back();
    total_ = start;
    return start <= (1 + MOST_COPIES) * std::uint64_t{list.count};
}

void WorldParts::cut(const BoxList& list, StripParts parts) {
    while (!measure(list, parts)) parts = {parts.first, parts.last, parts.count / 2};
    if (entries_.size() < total_) entries_.resize(total_ + total_ / 8);
    Entry* entries = entries_.data();
    std::uint32_t* ends = ends_.data();  // of what is there so far
    const StripParts part_of = parts;
    for (unsigned i = 0; i < list.count; ++i) {
        Entry entry = {list.box(i), list.index(i)};
        std::uint32_t part = part_of(entry.box.min.y);
        const std::uint32_t last = part_of(entry.box.max.y);
        entries[ends[part]++] = entry;
        entry.box.min.y = VISITOR;
        while (part < last) entries[ends[++part]++] = entry;
    }
}

}  // namespace collision
