// world_parts.cpp - see world_parts.h
#include "collision/broad/world_parts.h"

#include <algorithm>
#include <array>

namespace collision {
namespace {

constexpr unsigned CHUNK = 1024;  // boxes whose parts stay in the cache nearest to the processor
constexpr unsigned AHEAD = 32;    // entries; more streams than a processor foresees by itself
constexpr unsigned GUESS_FROM = 1 << 16;  // boxes, for less it is not worth it
constexpr unsigned GUESS_BY = 61;         // every so many-th box

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

// Room for what a sample makes likely, and a third more.
void WorldParts::guess(const BoxList& list, const StripParts& parts) {
    ends_.assign(parts.count, 0);
    for (unsigned i = 0; i < list.count; i += GUESS_BY) ++ends_[parts(list.box(i).min.y)];
    for (std::uint32_t& count : ends_) count = count * (GUESS_BY + GUESS_BY / 3) + CHUNK;
}

// Room for exactly what there is.  False if there are too many copies.
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
    return enough;
}

// From the room of each part.  False if that is not enough for one.
bool WorldParts::scatter(const Kernels& kernels, const BoxList& list, const StripParts& parts) {
    starts_.clear();
    std::uint32_t start = 0;
    for (const std::uint32_t room : ends_) {
        starts_.push_back(start);
        start += room;
    }
    starts_.push_back(start);
    if (entries_.size() < start) entries_.resize(start + start / 8);
    std::copy(starts_.begin(), starts_.end() - 1, ends_.begin());

    Entry* entries = entries_.data();
    std::uint32_t* ends = ends_.data();  // of what is there so far
    const std::uint32_t* limits = starts_.data() + 1;
    const BoxList from = list;  // a copy, or each entry that is written might change it
    bool enough = true;
    const auto put = [=, &enough](const Entry& entry, std::uint32_t part) {
        const std::uint32_t to = ends[part];
        if (to == limits[part]) {
            enough = false;
            return;
        }
        __builtin_prefetch(entries + to + AHEAD, 1);
        entries[to] = entry;
        ends[part] = to + 1;
    };
    deal(
        kernels, list, parts,
        [=](unsigned i, std::uint32_t part) {
            put({from.box(i), from.index(i)}, part);
        },
        [=](unsigned i, std::uint32_t part, std::uint32_t last) {
            Entry entry = {from.box(i), from.index(i)};
            entry.box.min.y = VISITOR;
            while (part < last) put(entry, ++part);
        });
    return enough;
}

void WorldParts::cut(const Kernels& kernels, const BoxList& list, StripParts parts) {
    if (list.count >= GUESS_FROM) {
        guess(list, parts);
        if (scatter(kernels, list, parts)) return;
    }
    while (!measure(kernels, list, parts)) parts = {parts.first, parts.last, parts.count / 2};
    scatter(kernels, list, parts);
}

}  // namespace collision
