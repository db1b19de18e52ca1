// world_parts.cpp - see world_parts.h
#include "collision/broad/world_parts.h"

#include <algorithm>
#include <array>

#include "collision/broad/huge_pages.h"

namespace collision {
namespace {

constexpr unsigned CHUNK = 512;    // boxes whose parts stay in the cache nearest to the processor
constexpr unsigned AHEAD = 8;      // entries; more streams than a processor foresees by itself
constexpr unsigned GUESS_BY = 61;  // every so many-th box
constexpr unsigned GUESS_FROM = 2048;   // boxes a part, or room to spare would be most of it all
constexpr unsigned MARGIN = 4 * CHUNK;  // entries, for parts that have more than the sample's share
constexpr unsigned SPARE = CHUNK;       // what one chunk may add to a part at most

// Calls see(i, part) for each box, then see_tall(i, part, last) for those that go on beyond their
// first part, then go_on(), chunk by chunk.  False as soon as go_on() is.
template <class See, class SeeTall, class GoOn>
bool deal(const Kernels& kernels, const BoxList& list, const StripParts& parts, See see,
          SeeTall see_tall, GoOn go_on) {
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
        if (!go_on()) return false;
    }
    return true;
}

Entry entry_of(const Aabb* boxes, unsigned i) { return {boxes[i], i}; }
Entry entry_of(const Entry* entries, unsigned i) { return entries[i]; }

// Writes each entry to where its part ends so far.  False if a part has got so near to its limit
// that the next chunk might not fit.
template <class Box>
bool write(const Kernels& kernels, const Box* boxes, const BoxList& list, const StripParts& parts,
           Entry* entries, std::uint32_t* ends, const std::uint32_t* limits, unsigned spare) {
    const auto put = [=](const Entry& entry, std::uint32_t part) {
        const std::uint32_t to = ends[part]++;
        __builtin_prefetch(entries + to + AHEAD, 1);
        entries[to] = entry;
    };
    return deal(
        kernels, list, parts,
        [=](unsigned i, std::uint32_t part) {
            __builtin_prefetch(boxes + i + CHUNK);
            put(entry_of(boxes, i), part);
        },
        [=](unsigned i, std::uint32_t part, std::uint32_t last) {
            Entry entry = entry_of(boxes, i);
            entry.box.min.y = VISITOR;
            while (part < last) put(entry, ++part);
        },
        [=, &parts] {
            bool room = true;
            for (unsigned i = 0; i < parts.count; ++i) room &= ends[i] + spare <= limits[i];
            return room;
        });
}

}  // namespace

// Room for what a sample makes likely, and a third more.
void WorldParts::guess(const BoxList& list, const StripParts& parts) {
    ends_.assign(parts.count, 0);
    for (unsigned i = 0; i < list.count; i += GUESS_BY) ++ends_[parts(list.box(i).min.y)];
    for (std::uint32_t& count : ends_) count = count * (GUESS_BY + GUESS_BY / 3) + MARGIN + SPARE;
}

// Room for exactly what there is.  False if there are too many copies.
bool WorldParts::measure(const Kernels& kernels, const BoxList& list, const StripParts& parts) {
    ends_.assign(parts.count, 0);
    std::uint32_t* counts = ends_.data();
    const std::uint64_t most = MOST_COPIES * std::uint64_t{list.count};
    std::uint64_t copies = 0;
    return deal(
        kernels, list, parts, [=](unsigned, std::uint32_t part) { ++counts[part]; },
        [counts, &copies](unsigned, std::uint32_t part, std::uint32_t last) {
            copies += last - part;
            while (part < last) ++counts[++part];
        },
        [most, &copies] { return copies <= most; });
}

// From the room of each part, `spare` of which is kept free up to the last chunk.  False if that is
// not enough for one.
bool WorldParts::scatter(const Kernels& kernels, const BoxList& list, const StripParts& parts,
                         unsigned spare) {
    starts_.clear();
    std::uint32_t start = 0;
    for (const std::uint32_t room : ends_) {
        starts_.push_back(start);
        start += room;
    }
    starts_.push_back(start);
    if (entries_.size() < start) resize_in_huge_pages(entries_, start + start / 8);
    std::copy(starts_.begin(), starts_.end() - 1, ends_.begin());
    const std::uint32_t* limits = starts_.data() + 1;
    return list.boxes ? write(kernels, list.boxes, list, parts, entries_.data(), ends_.data(),
                              limits, spare)
                      : write(kernels, list.entries, list, parts, entries_.data(), ends_.data(),
                              limits, spare);
}

void WorldParts::cut(const Kernels& kernels, const BoxList& list, StripParts parts) {
    if (parts.count <= list.count / GUESS_FROM) {
        guess(list, parts);
        if (scatter(kernels, list, parts, SPARE)) return;
    }
    while (!measure(kernels, list, parts)) parts = {parts.first, parts.last, parts.count / 2};
    scatter(kernels, list, parts, 0);
}

}  // namespace collision
