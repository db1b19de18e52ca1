// strips.cpp - see broad_phase.h
#include <algorithm>
#include <limits>

#include "collision/broad_phase.h"
#include "pair_writer.h"
#include "radix_sort.h"

namespace collision {

namespace {

using detail::BoxList;
using detail::Buckets;
using detail::StripScale;

constexpr unsigned STRIP_HEIGHT = 4;  // in mean heights of a box, so that few are visitors
constexpr unsigned IN_BUCKET = 2;     // boxes, on average
constexpr unsigned MOST_STRIPS = 1024;
constexpr unsigned MOST_LEVELS = 8;
constexpr unsigned FEW = 64;  // a strip with so many boxes or fewer is not divided again

// The extent of the boxes and their mean height, estimated from some hundreds of them.  Boxes
// outside are found, too; only the speed depends on this.
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
            if (box.min.y == detail::VISITOR_MIN_Y) continue;
            min.y = std::min(min.y, box.min.y);
            max.y = std::max(max.y, box.min.y);
        }
        if (min.y > max.y) min.y = max.y;  // there are only visitors
        for (unsigned i = 0; i < list.count; i += step, ++taken) {
            const Aabb box = list.box(i);
            const std::int64_t top = std::min(box.max.y, max.y);
            height += static_cast<std::uint64_t>(
                std::max<std::int64_t>(top - std::max(box.min.y, min.y), 0));
        }
        height = height / std::max(taken, 1u) + 1;
    }

    unsigned strips() const {
        const std::uint32_t span =
            static_cast<std::uint32_t>(max.y) - static_cast<std::uint32_t>(min.y);
        const std::uint64_t strip = STRIP_HEIGHT * height;
        return static_cast<unsigned>(
            std::clamp<std::uint64_t>((span + strip / 2) / strip, 1, MOST_STRIPS));
    }
};

}  // namespace

void Strips::find(const Aabb* boxes, unsigned count, PairList& overlaps) {
    detail::PairWriter pairs(overlaps);
    levels_.resize(MOST_LEVELS);
    if (count > 1) find({boxes, nullptr, count}, 0, pairs);
    pairs.finish();
}

void Strips::find(const BoxList& list, unsigned depth, detail::PairWriter& pairs) {
    const Sample sample(list);
    unsigned strips = sample.strips();
    Buckets buckets(sample.min.x, sample.max.x, list.count / strips / IN_BUCKET + 1);
    detail::StripGrid& grid = levels_[depth];
    while (!grid.sort(*kernels_, list, {sample.min.y, sample.max.y, strips}, buckets)) strips /= 2;
    for (const auto& [begin, end, even] : grid.strips()) {
        const BoxList strip = {list.boxes, grid.entries() + begin, end - begin};
        if (even || strip.count < FEW)
            kernels_->sweep(
                sorted_.fill(*kernels_, strip.boxes, strip.entries, strip.count, buckets), pairs);
        else if (strip.count <= list.count - list.count / 4 && depth + 1 < MOST_LEVELS)
            find(strip, depth + 1, pairs);
        else  // dividing it again would change little
            sweep_exactly(strip, pairs);
    }
}

// In the exact order of min.x, without buckets.
void Strips::sweep_exactly(const BoxList& strip, detail::PairWriter& pairs) {
    keys_.clear();
    for (unsigned i = 0; i < strip.count; ++i)
        keys_.push_back(detail::sort_key(strip.box(i).min.x, strip.entry(i)));
    detail::radix_sort(keys_, spare_);
    entries_.clear();
    for (const std::uint64_t key : keys_) entries_.push_back(detail::index_of(key));
    entries_.resize(strip.count + detail::SLACK, entries_.front());
    const BoxList sorted = {strip.boxes, entries_.data(), strip.count};
    const auto buckets =
        Buckets::of_one_unit(sorted.box(0).min.x, sorted.box(strip.count - 1).min.x);
    kernels_->sweep(sorted_.fill(*kernels_, strip.boxes, entries_.data(), strip.count, buckets),
                    pairs);
}

std::size_t Strips::bytes() const {
    std::size_t bytes = 8 * (keys_.capacity() + spare_.capacity()) + 4 * entries_.capacity();
    for (const detail::StripGrid& level : levels_) bytes += level.bytes();
    return bytes + sorted_.bytes();
}

}  // namespace collision
