// strips.cpp - see strips.h
#include "collision/broad/strips.h"

#include <algorithm>
#include <limits>

namespace collision {
namespace {

// Boxes.  To fetch more than these one by one costs more than to copy them into parts, which are
// the strips unless those were smaller than is worth a part.
constexpr unsigned MOST_IN_GRID = 1 << 17;
constexpr unsigned LEAST_IN_PART = 1 << 12;
constexpr unsigned MOST_STRIPS = 1024;
constexpr unsigned MOST_LEVELS = 8;
constexpr unsigned IN_BUCKET = 2;  // boxes at least, on average
constexpr unsigned FINER = 2;      // buckets a box where boxes are known to crowd
constexpr unsigned FEW = 256;      // boxes that are not worth cutting again
constexpr unsigned CROWDED = 4;    // times the mean number of boxes in a strip

// Where the boxes are and how tall, from some hundreds of them.  Boxes outside are still found;
// only the speed depends on it.
struct Sample {
    Vec2 min = {std::numeric_limits<std::int32_t>::max(), std::numeric_limits<std::int32_t>::max()};
    Vec2 max = {std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::min()};
    std::uint64_t height = 0;  // on average, at least 1

    explicit Sample(const BoxList& list) {
        const unsigned step = list.count / 256 + 1;
        unsigned taken = 0;
        for (unsigned i = 0; i < list.count; i += step) {
            const Aabb box = list.box(i);
            min.x = std::min(min.x, box.min.x);
            max.x = std::max(max.x, box.min.x);
            if (box.min.y == VISITOR) continue;
            min.y = std::min(min.y, box.min.y);
            max.y = std::max(max.y, box.min.y);
        }
        for (unsigned i = 0; i < list.count; i += step, ++taken) {
            const Aabb box = list.box(i);
            const std::int64_t top = std::min(box.max.y, max.y);
            height += static_cast<std::uint64_t>(
                std::max<std::int64_t>(top - std::max(box.min.y, min.y), 0));
        }
        height = height / std::max(taken, 1u) + 1;
        if (min.y > max.y) min.y = max.y;  // nothing but visitors
    }
    StripParts strips(unsigned heights) const {
        const std::uint32_t span =
            static_cast<std::uint32_t>(max.y) - static_cast<std::uint32_t>(min.y);
        const std::uint64_t strip = heights * height;
        const auto wanted = std::clamp<std::uint64_t>((span + strip / 2) / strip, 1, MOST_STRIPS);
        return {min.y, max.y, static_cast<unsigned>(wanted)};
    }
    BucketParts buckets(unsigned in_strip) const {
        return {min.x, max.x, in_strip / IN_BUCKET + 1};
    }
};

const StripParts ONE_STRIP = {0, 0, 1};
const BucketParts ONE_BUCKET = {0, 0, 1};

}  // namespace

void Strips::find(const Aabb* boxes, unsigned count, PairList& overlaps) {
    PairRoom room(overlaps);
    levels_.resize(MOST_LEVELS);
    if (count > 1) find(list_of(boxes, count), 0, room);
    room.finish();
}

void Strips::find(const BoxList& list, unsigned depth, PairRoom& room) {
    const Sample sample(list);
    StripParts parts = sample.strips(kernels_->strip_heights);
    const bool large = list.count > MOST_IN_GRID;  // which is no sign that boxes crowd
    const unsigned strips = parts.count;
    if (!large) {
        if (grid_.sort(list, {parts, sample.buckets(list.count / strips)})) return sweep(room);
    } else {
        parts = {parts.first, parts.last, std::min(strips, list.count / LEAST_IN_PART)};
    }

    WorldParts& level = levels_[depth];
    level.cut(*kernels_, list, parts);
    // Cutting again is worth it only where this time has made a difference.
    const unsigned crowd = std::max(FEW, CROWDED * (list.count / strips));
    const unsigned most = list.count - list.count / 4;
    for (unsigned i = 0; i < level.count(); ++i) {
        const BoxList part = level.part(i);
        if (part.count < 2) continue;
        if (part.count > crowd && part.count < most && depth + 1 < MOST_LEVELS) {
            find(part, depth + 1, room);
            continue;
        }
        const BucketParts buckets = sample.buckets(IN_BUCKET * (large ? 1 : FINER) * part.count);
        if (part.packed) {
            const BoxList soon = level.part(i + 1 < level.count() ? i + 1 : i);
            if (packed_.sort(part.packed, part.count, buckets, soon.packed)) {
                kernels_->strip_rows(packed_.rows(), room);
                continue;
            }
        }
        if (part.packed || !grid_.sort(part, {ONE_STRIP, buckets})) grid_.sort_exactly(part);
        sweep(room);
    }
}

void Strips::sweep(PairRoom& room) {
    for (unsigned strip = 0; strip < grid_.strips(); ++strip)
        kernels_->strip_rows(grid_.rows(strip), room);
}

std::size_t Strips::bytes() const {
    std::size_t bytes = grid_.bytes() + packed_.bytes();
    for (const WorldParts& level : levels_) bytes += level.bytes();
    return bytes;
}

}  // namespace collision
