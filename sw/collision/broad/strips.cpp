// strips.cpp - see strips.h
#include "collision/broad/strips.h"

#include <algorithm>
#include <limits>

namespace collision {
namespace {

constexpr unsigned MOST_STRIPS = 1024;  // the places that are written to in turn fit the cache
constexpr unsigned MOST_LEVELS = 8;
constexpr unsigned HEIGHTS = 4;      // of a strip, in mean heights of a box
constexpr unsigned FEW = 256;        // boxes that are not worth cutting again
constexpr unsigned MOST_COPIES = 2;  // of a box, on average
constexpr unsigned CROWDED = 4;      // times the mean number of boxes in a strip

// Where the boxes are and how tall, from a thousand of them.  Boxes outside are still found; only
// the speed depends on it.
struct Sample {
    Vec2 min = {std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::max()};
    Vec2 max = {std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::min()};
    std::uint64_t height = 0;  // on average, at least 1

    template <class Source>
    Sample(const Source& source, unsigned count) {
        const unsigned step = count / 1024 + 1;
        unsigned taken = 0;
        for (unsigned i = 0; i < count; i += step) {
            const Aabb& box = source.box(i);
            min.x = std::min(min.x, box.min.x);
            max.x = std::max(max.x, box.max.x);
            if (box.min.y == VISITOR) continue;
            min.y = std::min(min.y, box.min.y);
            max.y = std::max(max.y, box.min.y);
        }
        for (unsigned i = 0; i < count; i += step, ++taken) {
            const Aabb& box = source.box(i);
            const std::int64_t top = std::min(box.max.y, max.y);
            height += static_cast<std::uint64_t>(
                std::max<std::int64_t>(top - std::max(box.min.y, min.y), 0));
        }
        height = height / std::max(taken, 1u) + 1;
    }
    std::uint32_t span() const {
        return static_cast<std::uint32_t>(max.y) - static_cast<std::uint32_t>(min.y);
    }
    unsigned strips() const {
        if (max.y <= min.y) return 1;
        return static_cast<unsigned>(
            std::min<std::uint64_t>(span() / (HEIGHTS * height) + 1, MOST_STRIPS));
    }
};

}  // namespace

// The strip of a position; positions outside belong to the first and the last.
struct Strips::StripOf {
    unsigned strips;
    std::int32_t bottom, top;
    std::uint64_t scale;  // strips a unit, times 2^32

    StripOf(const Sample& sample, unsigned wanted)
        : strips{wanted},
          bottom{sample.min.y},
          top{std::max(sample.min.y, sample.max.y)},
          scale{(std::uint64_t{wanted} << 32) / (std::uint64_t{sample.span()} + 1)} {}

    std::uint32_t operator()(std::int32_t at) const {
        const std::uint32_t offset =
            static_cast<std::uint32_t>(std::min(std::max(at, bottom), top)) -
            static_cast<std::uint32_t>(bottom);
        return static_cast<std::uint32_t>(offset * scale >> 32);
    }
};

namespace {

struct FromBoxes {
    const Aabb* boxes;
    const Aabb& box(unsigned i) const { return boxes[i]; }
    std::uint32_t index(unsigned i) const { return i; }
};

struct FromEntries {
    const Entry* entries;
    const Aabb& box(unsigned i) const { return entries[i].box; }
    std::uint32_t index(unsigned i) const { return entries[i].index; }
};

}  // namespace

void Strips::find(const Aabb* boxes, unsigned count, PairList& overlaps) {
    PairWriter writer(overlaps);
    levels_.resize(MOST_LEVELS);
    if (count > 1) cut(FromBoxes{boxes}, count, 0, writer);
    writer.finish();
}

// Finds where the entries of each strip go.  False if there are too many for the number of boxes.
template <class Source>
bool Strips::reserve(const Source& source, unsigned count, const StripOf& strip_of, Level& level) {
    auto& places = level.places;
    places.assign(strip_of.strips, 0);
    for (unsigned i = 0; i < count; ++i) {
        const std::uint32_t first = strip_of(source.box(i).min.y);
        const std::uint32_t last = strip_of(source.box(i).max.y);
        ++places[first];
        places[last] += last != first;
        for (std::uint32_t strip = first + 1; strip < last; ++strip) ++places[strip];
    }
    std::uint64_t total = 0;
    for (const std::uint32_t in_strip : places) total += in_strip + 1;  // with one to spare
    if (strip_of.strips > 1 && total > MOST_COPIES * std::uint64_t{count} + strip_of.strips)
        return false;

    level.starts.resize(strip_of.strips);
    std::uint32_t place = 0;
    for (unsigned strip = 0; strip < strip_of.strips; ++strip) {
        level.starts[strip] = place;
        place += places[strip] + 1;
        places[strip] = level.starts[strip];
    }
    if (level.entries.size() < place) level.entries.resize(std::size_t{place} + place / 8);
    return true;
}

template <class Source>
void Strips::cut(const Source& source, unsigned count, unsigned depth, PairWriter& writer) {
    const Sample sample(source, count);
    Level& level = levels_[depth];
    unsigned strips = sample.strips();
    while (!reserve(source, count, {sample, strips}, level)) strips /= 2;

    const StripOf strip_of = {sample, strips};
    const auto& starts = level.starts;
    auto& places = level.places;
    Entry* entries = level.entries.data();
    for (unsigned i = 0; i < count; ++i) {
        Entry entry = {source.box(i), source.index(i)};
        const std::uint32_t first = strip_of(entry.box.min.y), last = strip_of(entry.box.max.y);
        entries[places[first]++] = entry;
        entry.box.min.y = VISITOR;
        entries[places[last]] = entry;  // into the place to spare if it is the same strip
        places[last] += last != first;
        for (std::uint32_t strip = first + 1; strip < last; ++strip)
            entries[places[strip]++] = entry;
    }

    const unsigned crowd = std::max(FEW, CROWDED * (count / strips));
    for (unsigned strip = 0; strip < strips; ++strip) {
        const Entry* in_strip = entries + starts[strip];
        const unsigned in_strip_count = places[strip] - starts[strip];
        if (in_strip_count < 2) continue;
        if (in_strip_count > crowd && depth + 1 < MOST_LEVELS)
            cut(FromEntries{in_strip}, in_strip_count, depth + 1, writer);
        else
            sweep(in_strip, in_strip_count, sample.min.x, sample.max.x, writer);
    }
}

void Strips::sweep(const Entry* entries, unsigned count, std::int32_t left, std::int32_t right,
                   PairWriter& writer) {
    const StripRows rows = strip_.sort(entries, count, left, right);
    unsigned row = 0;
    writer.write(count, [&](PairRoom& room) {
        row = kernels_->strip_rows(rows, row, room);
        return row == count;
    });
}

std::size_t Strips::bytes() const {
    std::size_t bytes = strip_.bytes();
    for (const Level& level : levels_)
        bytes += level.entries.capacity() * sizeof(Entry) +
                 4 * (level.places.capacity() + level.starts.capacity());
    return bytes;
}

}  // namespace collision
