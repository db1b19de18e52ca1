// strips.cpp - see strips.h
#include "collision/broad/strips.h"

#include <algorithm>
#include <limits>

namespace collision {
namespace {

constexpr unsigned MOST_STRIPS = 1024;      // the places that are written to in turn fit the cache
constexpr unsigned MOST_IN_GRID = 1 << 12;  // boxes; these, too, fit the cache
constexpr unsigned MOST_LEVELS = 8;
constexpr unsigned HEIGHTS = 4;      // of a strip, in mean heights of a box
constexpr unsigned FEW = 256;        // boxes that are not worth cutting again
constexpr unsigned MOST_COPIES = 2;  // of a box, on average
constexpr unsigned SPARE = 32;       // places of a strip, besides an eighth
constexpr unsigned CROWDED = 4;      // times the mean number of boxes in a strip

// Where the boxes are and how tall, from some hundreds of them.  Boxes outside are still found;
// only the speed depends on it.
struct Sample {
    Vec2 min = {std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::max()};
    Vec2 max = {std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::min()};
    std::uint64_t height = 0;  // on average, at least 1

    template <class Source>
    Sample(const Source& source, unsigned count) {
        const unsigned step = count / 256 + 1;
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
        if (min.y > max.y) min.y = max.y;  // nothing but visitors
    }
    std::uint32_t span() const {
        return static_cast<std::uint32_t>(max.y) - static_cast<std::uint32_t>(min.y);
    }
    unsigned strips() const {
        return static_cast<unsigned>(
            std::min<std::uint64_t>(span() / (HEIGHTS * height) + 1, MOST_STRIPS));
    }
};

}  // namespace

void Strips::find(const Aabb* boxes, unsigned count, PairList& overlaps) {
    PairWriter writer(overlaps);
    levels_.resize(MOST_LEVELS);
    if (count > 1) find(FromBoxes{boxes}, count, 0, writer);
    writer.finish();
}

bool Strips::Level::suits(unsigned boxes, unsigned strips) const {
    const unsigned off = std::max(strips, wanted) - std::min(strips, wanted);
    return boxes == count && off <= wanted / 4;
}

// Finds room for the entries of each strip.  False if there are too many for the number of boxes.
template <class Source>
bool Strips::reserve(const Source& source, unsigned count, Level& level) {
    const StripOf strip_of = level.strip_of;
    auto& places = level.places;
    places.assign(strip_of.count, 0);
    std::uint64_t total = 0;
    for (unsigned i = 0; i < count; ++i) {
        const std::uint32_t first = strip_of(source.box(i).min.y);
        const std::uint32_t last = strip_of(source.box(i).max.y);
        total += last - first + 1;
        ++places[first];
        places[last] += last != first;
        for (std::uint32_t strip = first + 1; strip < last; ++strip) ++places[strip];
    }
    if (strip_of.count > 1 && total > MOST_COPIES * std::uint64_t{count}) return false;

    level.starts.resize(strip_of.count + 1);
    std::uint32_t place = 0;
    for (unsigned strip = 0; strip < strip_of.count; ++strip) {
        level.starts[strip] = place;
        place += places[strip] + places[strip] / 8 + SPARE;
    }
    level.starts.back() = place;
    if (level.entries.size() < place) level.entries.resize(place);
    return true;
}

// False if a strip has no room left for its entries, one more, and so none for the rest.
template <class Source>
bool Strips::scatter(const Source& source, unsigned count, Level& level) {
    const StripOf strip_of = level.strip_of;
    std::copy(level.starts.begin(), level.starts.end() - 1, level.places.begin());
    std::uint32_t* places = level.places.data();
    const std::uint32_t* ends = level.starts.data() + 1;
    Entry* entries = level.entries.data();
    for (unsigned i = 0; i < count; ++i) {
        Entry entry = {source.box(i), source.index(i)};
        const std::uint32_t first = strip_of(entry.box.min.y), last = strip_of(entry.box.max.y);
        if ((places[first] + 1 >= ends[first]) | (places[last] >= ends[last])) return false;
        entries[places[first]++] = entry;
        entry.box.min.y = VISITOR;
        entries[places[last]] = entry;  // into the place to spare if it is the same strip
        places[last] += last != first;
        for (std::uint32_t strip = first + 1; strip < last; ++strip) {
            if (places[strip] >= ends[strip]) return false;
            entries[places[strip]++] = entry;
        }
    }
    return true;
}

template <class Source>
void Strips::find(const Source& source, unsigned count, unsigned depth, PairWriter& writer) {
    const Sample sample(source, count);
    unsigned strips = sample.strips();
    if (count <= MOST_IN_GRID) {
        const BucketOf buckets = {sample.min.x, sample.max.x, count / strips + 1};
        const StripOf strip_of = {sample.min.y, sample.max.y, strips};
        if (grid_.sort(source, count, strip_of, buckets)) return sweep(writer);
    }

    Level& level = levels_[depth];
    const bool again = depth == 0 && level.suits(count, strips) && scatter(source, count, level);
    if (!again) {
        level.count = count;
        level.wanted = strips;
        level.strip_of = {sample.min.y, sample.max.y, strips};
        while (!reserve(source, count, level))
            level.strip_of = {sample.min.y, sample.max.y, level.strip_of.count / 2};
        scatter(source, count, level);
    }
    strips = level.strip_of.count;
    // Cutting again is worth it only where this time has made a difference.
    const unsigned crowd = std::max(FEW, CROWDED * (count / strips));
    const unsigned most = count - count / 4;
    for (unsigned strip = 0; strip < strips; ++strip) {
        const Entry* entries = level.entries.data() + level.starts[strip];
        const unsigned in_strip = level.places[strip] - level.starts[strip];
        if (in_strip < 2) continue;
        if (in_strip > crowd && in_strip < most && depth + 1 < MOST_LEVELS) {
            find(FromEntries{entries}, in_strip, depth + 1, writer);
            continue;
        }
        if (!grid_.sort(FromEntries{entries}, in_strip, OneStrip{},
                        {sample.min.x, sample.max.x, 2 * in_strip}))
            grid_.sort_exactly(entries, in_strip);
        sweep(writer);
    }
}

void Strips::sweep(PairWriter& writer) {
    for (unsigned strip = 0; strip < grid_.strips(); ++strip) {
        const StripRows& rows = grid_.rows(strip);
        unsigned row = 0;
        writer.write(rows.count + StripRows::PADDING, [&](PairRoom& room) {
            row = kernels_->strip_rows(rows, row, room);
            return row == rows.count;
        });
    }
}

std::size_t Strips::bytes() const {
    std::size_t bytes = grid_.bytes();
    for (const Level& level : levels_)
        bytes += level.entries.capacity() * sizeof(Entry) +
                 4 * (level.places.capacity() + level.starts.capacity());
    return bytes;
}

}  // namespace collision
