// world_parts.cpp - see world_parts.h
#include "collision/broad/world_parts.h"

#include <algorithm>
#include <array>

namespace collision {
namespace {

constexpr unsigned CHUNK = 1024;  // boxes whose parts stay in the cache nearest to the processor

// Calls see(entry, part) for each box, then see_tall(entry, part, last) for those that go on beyond
// their first part; chunk by chunk.
template <class See, class SeeTall>
void deal(const Kernels& kernels, const BoxList& list, const StripParts& parts, See see,
          SeeTall see_tall) {
    std::array<std::uint32_t, CHUNK + BOX_CELLS_SLACK> part_of, tall;
    for (unsigned start = 0; start < list.count; start += CHUNK) {
        const BoxList chunk = list.section(start, std::min(CHUNK, list.count - start));
        const unsigned tall_count =
            kernels.box_cells(chunk, {parts, {0, 0, 1}}, part_of.data(), tall.data());
        for (unsigned i = 0; i < chunk.count; ++i) see(start + i, part_of[i]);
        for (unsigned k = 0; k < tall_count; ++k) {
            const unsigned i = tall[k];
            see_tall(start + i, part_of[i], parts(chunk.box(i).max.y));
        }
    }
}

}  // namespace

// Finds where each part begins.  False if there are too many copies.
bool WorldParts::measure(const Kernels& kernels, const BoxList& list, const StripParts& parts) {
    ends_.assign(parts.count, 0);
    std::uint32_t* counts = ends_.data();
    std::uint64_t room = MOST_COPIES * std::uint64_t{list.count};  // for more copies
    bool enough = true;
    deal(
        kernels, list, parts, [=](unsigned, std::uint32_t part) { ++counts[part]; },
        [&room, &enough, counts](unsigned, std::uint32_t part, std::uint32_t last) {
            enough &= last - part <= room;
            if (!enough) return;
            room -= last - part;
            while (part < last) ++counts[++part];
        });
    std::uint32_t start = 0;
    for (std::uint32_t& at : ends_) {
        const std::uint32_t count = at;
        at = start;
        start += count;
    }
    if (enough && entries_.size() < start) entries_.resize(start + start / 8);
    return enough;
}

void WorldParts::cut(const Kernels& kernels, const BoxList& list, StripParts parts) {
    while (!measure(kernels, list, parts)) parts = {parts.first, parts.last, parts.count / 2};
    Entry* entries = entries_.data();
    std::uint32_t* ends = ends_.data();  // of what is there so far
    const BoxList from = list;           // a copy, or each entry that is written might change it
    deal(
        kernels, list, parts,
        [=](unsigned i, std::uint32_t part) {
            entries[ends[part]++] = {from.box(i), from.index(i)};
        },
        [=](unsigned i, std::uint32_t part, std::uint32_t last) {
            Entry entry = {from.box(i), from.index(i)};
            entry.box.min.y = VISITOR;
            while (part < last) entries[ends[++part]++] = entry;
        });
}

}  // namespace collision
