// world_parts.cpp - see world_parts.h
#include "collision/broad/world_parts.h"

#include <algorithm>
#include <array>

#include "collision/broad/huge_pages.h"
#include "collision/broad/pack.h"

namespace collision {
namespace {

constexpr unsigned CHUNK = 512;    // boxes whose parts stay in the cache nearest to the processor
constexpr unsigned AHEAD = 8;      // entries; more streams than a processor foresees by itself
constexpr unsigned GUESS_BY = 61;  // every so many-th cache line
constexpr unsigned IN_LINE = 64 / sizeof(Aabb);
constexpr unsigned GUESS_FROM = 2048;   // boxes a part, or room to spare would be most of it all
constexpr unsigned MARGIN = 4 * CHUNK;  // entries, for parts that have more than the sample's share
constexpr unsigned SPARE = CHUNK;       // what one chunk may add to a part at most

struct Chunk {
    unsigned start, count, tall_count;
    std::array<std::uint32_t, CHUNK + BOX_CELLS_SLACK> part_of, tall;  // counted from `start`
};

// Calls see(chunk) for each.  False as soon as that is.
template <class See>
bool deal(const Kernels& kernels, const BoxList& list, const StripParts& parts, See see) {
    Chunk chunk;
    for (chunk.start = 0; chunk.start < list.count; chunk.start += CHUNK) {
        chunk.count = std::min(CHUNK, list.count - chunk.start);
        chunk.tall_count =
            kernels.box_cells(list.section(chunk.start, chunk.count), {parts, {0, 0, 1}},
                              chunk.part_of.data(), chunk.tall.data());
        if (!see(chunk)) return false;
    }
    return true;
}

// Writes each entry to where its part ends so far.  Were all sides short?
template <class Pack, class Box>
bool write(const Box* boxes, const Chunk& chunk, const StripParts& parts,
           typename Pack::Written* entries, std::uint32_t* ends) {
    using Written = typename Pack::Written;
    const auto put = [entries, ends](const Written& entry, std::uint32_t part) {
        const std::uint32_t to = ends[part]++;
        __builtin_prefetch(entries + to + AHEAD, 1);
        entries[to] = entry;
    };
    Pack pack;
    const std::uint32_t* part_of = chunk.part_of.data();
    const unsigned start = chunk.start;  // a copy, or each entry written might have changed it
    const unsigned end = start + chunk.count;
    for (unsigned i = start; i < end; ++i) {
        __builtin_prefetch(boxes + i + CHUNK);
        put(pack(boxes, i), *part_of++);
    }
    const BoxList list = list_of(boxes + start, chunk.count);
    for (unsigned k = 0; k < chunk.tall_count; ++k) {
        const unsigned i = chunk.tall[k];
        const Written entry = Pack::visitor(pack(boxes, start + i));
        const std::uint32_t last = parts(list.box(i).max.y);
        for (std::uint32_t part = chunk.part_of[i]; part < last;) put(entry, ++part);
    }
    return pack.sides.all_short();
}

}  // namespace

// Room for what a sample makes likely, and a third more.
void WorldParts::guess(const BoxList& list, const StripParts& parts) {
    ends_.assign(parts.count, 0);
    for (unsigned i = 0; i + IN_LINE <= list.count; i += IN_LINE * GUESS_BY)
        for (unsigned k = 0; k < IN_LINE; ++k) ++ends_[parts(list.box(i + k).min.y)];
    for (std::uint32_t& count : ends_) count = count * (GUESS_BY + GUESS_BY / 3) + MARGIN + SPARE;
}

// Room for exactly what there is.  False if there are too many copies.
bool WorldParts::measure(const Kernels& kernels, const BoxList& list, const StripParts& parts) {
    ends_.assign(parts.count, 0);
    const std::uint64_t most = MOST_COPIES * std::uint64_t{list.count};
    std::uint64_t copies = 0;
    return deal(kernels, list, parts, [&](const Chunk& chunk) {
        for (unsigned i = 0; i < chunk.count; ++i) ++ends_[chunk.part_of[i]];
        for (unsigned k = 0; k < chunk.tall_count; ++k) {
            std::uint32_t part = chunk.part_of[chunk.tall[k]];
            const std::uint32_t last = parts(list.box(chunk.start + chunk.tall[k]).max.y);
            copies += last - part;
            while (part < last) ++ends_[++part];
        }
        return copies <= most;
    });
}

// Into the room of each part, `spare` of which is kept free up to the last chunk.
template <class Pack>
WorldParts::Outcome WorldParts::scatter(const Kernels& kernels, const BoxList& list,
                                        const StripParts& parts, unsigned spare,
                                        std::vector<typename Pack::Written>& entries) {
    starts_.clear();
    std::uint32_t start = 0;
    for (const std::uint32_t room : ends_) {
        starts_.push_back(start);
        start += room;
    }
    starts_.push_back(start);
    if (entries.size() < start + PACKED_SLACK) {
        const std::size_t room = start + start / 8 + PACKED_SLACK;
        entries.clear();
        reserve_in_huge_pages(entries, room);
        entries.resize(room);
    }
    std::copy(starts_.begin(), starts_.end() - 1, ends_.begin());
    Outcome outcome = Outcome::DONE;
    all_short_ = true;
    deal(kernels, list, parts, [&](const Chunk& chunk) {
        std::uint32_t* ends = ends_.data();
        all_short_ &= list.boxes
                          ? write<Pack>(list.boxes, chunk, parts, entries.data(), ends)
                          : write<Pack>(Pack::written(list), chunk, parts, entries.data(), ends);
        bool room = true;
        for (unsigned i = 0; i < parts.count; ++i) room &= ends[i] + spare <= starts_[i + 1];
        if (!Pack::ANY_SIDES && !all_short_)
            outcome = Outcome::TOO_LONG;
        else if (!room)
            outcome = Outcome::NO_ROOM;
        return outcome == Outcome::DONE;
    });
    return outcome;
}

// False if a side is too long.
template <class Pack>
bool WorldParts::cut_as(const Kernels& kernels, const BoxList& list, StripParts parts,
                        std::vector<typename Pack::Written>& entries) {
    if (parts.count <= list.count / GUESS_FROM) {
        guess(list, parts);
        const Outcome outcome = scatter<Pack>(kernels, list, parts, SPARE, entries);
        if (outcome != Outcome::NO_ROOM) return outcome == Outcome::DONE;
    }
    while (!measure(kernels, list, parts)) parts = {parts.first, parts.last, parts.count / 2};
    return scatter<Pack>(kernels, list, parts, 0, entries) == Outcome::DONE;
}

void WorldParts::cut(const Kernels& kernels, const BoxList& list, const StripParts& parts) {
    const bool try_packed = list.packed || (list.boxes && all_short_);
    is_packed_ = try_packed && cut_as<Packed>(kernels, list, parts, packed_);
    if (is_packed_) {
        std::vector<Entry>().swap(entries_);
    } else {
        std::vector<PackedEntry>().swap(packed_);
        cut_as<Unpacked>(kernels, list, parts, entries_);
    }
}

}  // namespace collision
