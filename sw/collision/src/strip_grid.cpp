// strip_grid.cpp - see strip_grid.h
#include "collision/detail/strip_grid.h"

#include <algorithm>

namespace collision::detail {

StripScale::StripScale(std::int32_t bottom_most, std::int32_t top_most, unsigned wanted)
    : bottom{bottom_most}, top{top_most}, shift{0} {
    const std::uint32_t span = static_cast<std::uint32_t>(top) - static_cast<std::uint32_t>(bottom);
    while (span >> shift >= 1u << 16) ++shift;
    const std::uint32_t units = (span >> shift) + 1;
    count = std::min<std::uint32_t>(wanted, units);
    scale = static_cast<std::uint32_t>((std::uint64_t{count} << 16) / units);
}

bool StripGrid::sort(const Kernels& kernels, const BoxList& list, const StripScale& scale,
                     const Buckets& buckets) {
    const BoxList boxes = list;  // copies: stores might change the originals
    const std::uint32_t in_strip = buckets.count;
    if (cells_.size() < boxes.count + SLACK) {
        const std::size_t size = boxes.count + boxes.count / 8 + SLACK;
        for (auto* array : {&cells_, &above_, &tall_}) array->resize(size);
    }
    kernels.locate(boxes, scale, buckets, cells_.data(), above_.data());

    // How many boxes are there in each cell?
    places_.assign(std::size_t{scale.count} * in_strip, 0);
    const std::uint32_t *cells = cells_.data(), *above = above_.data();
    std::uint32_t *places = places_.data(), *tall = tall_.data();
    unsigned tall_count = 0;
    std::uint64_t entries = boxes.count;
    for (unsigned i = 0; i < boxes.count; ++i) {
        ++places[cells[i]];
        tall[tall_count] = i;  // without a branch, which would be mispredicted
        tall_count += above[i] != 0;
        entries += above[i];
    }
    if (entries > (MOST_VISITORS + 1) * std::uint64_t{boxes.count}) return false;
    for (unsigned k = 0; k < tall_count; ++k)
        for (std::uint32_t cell = cells[tall[k]], left = above[tall[k]]; left > 0; --left)
            ++places[cell += in_strip];

    // Where does each cell begin?  For n boxes spread at random, with m others in their bucket on
    // average, the sum of the squares of the buckets' counts is n (m + 1).
    constexpr std::uint64_t UNEVEN = 32;
    strips_.clear();
    std::uint32_t place = 0;
    for (unsigned strip = 0; strip < scale.count; ++strip) {
        const std::uint32_t begin = place;
        std::uint64_t squares = 0;
        for (unsigned i = 0; i < buckets.count; ++i) {
            const std::uint32_t count = *places;
            squares += std::uint64_t{count} * count;
            *places++ = place;
            place += count;
        }
        strips_.push_back({begin, place, squares <= UNEVEN * (place - begin)});
    }

    if (entries_.size() < place + SLACK) entries_.resize(place + place / 8 + SLACK);
    std::uint32_t* to = entries_.data();
    std::fill_n(to + place, SLACK, boxes.entry(0));
    places = places_.data();
    for (unsigned i = 0; i < boxes.count; ++i) to[places[cells[i]]++] = boxes.entry(i);
    for (unsigned k = 0; k < tall_count; ++k)
        for (std::uint32_t cell = cells[tall[k]], left = above[tall[k]]; left > 0; --left)
            to[places[cell += in_strip]++] = boxes.entry(tall[k]) | VISITOR_BIT;
    return true;
}

std::size_t StripGrid::bytes() const {
    return 4 * (cells_.capacity() + above_.capacity() + tall_.capacity() + places_.capacity() +
                entries_.capacity()) +
           sizeof(Strip) * strips_.capacity();
}

}  // namespace collision::detail
