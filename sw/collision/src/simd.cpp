// simd.cpp - see broad_phase.h
#include <algorithm>
#include <array>
#include <limits>

#include "collision/broad_phase.h"
#include "lanes.h"
#include "pair_writer.h"

namespace collision {

namespace detail {

namespace {

constexpr std::int32_t LAST = std::numeric_limits<std::int16_t>::max() - 1;

// Maps one axis of the world to -32768 .. LAST.
struct Scale {
    std::uint32_t origin;
    unsigned shift;

    Scale(std::int32_t min, std::int32_t max) : origin{static_cast<std::uint32_t>(min)}, shift{0} {
        constexpr std::uint32_t STEPS = LAST - std::numeric_limits<std::int16_t>::min();
        const std::uint32_t span = static_cast<std::uint32_t>(max) - origin;
        while (span >> shift > STEPS) ++shift;
    }

    std::int16_t operator()(std::int32_t at) const {
        const std::uint32_t steps = (static_cast<std::uint32_t>(at) - origin) >> shift;
        return static_cast<std::int16_t>(static_cast<std::int32_t>(steps) +
                                         std::numeric_limits<std::int16_t>::min());
    }
};

}  // namespace

void ShortBoxes::assign(const Aabb* boxes, unsigned count) {
    Aabb world = count ? boxes[0] : Aabb{};
    for (unsigned i = 1; i < count; ++i) {
        world.min.x = std::min(world.min.x, boxes[i].min.x);
        world.min.y = std::min(world.min.y, boxes[i].min.y);
        world.max.x = std::max(world.max.x, boxes[i].max.x);
        world.max.y = std::max(world.max.y, boxes[i].max.y);
    }
    const Scale x = {world.min.x, world.max.x}, y = {world.min.y, world.max.y};
    for (unsigned i = 0; i < count; ++i) {
        min_x[i] = x(boxes[i].min.x);
        min_y[i] = y(boxes[i].min.y);
        max_x[i] = x(boxes[i].max.x);
        max_y[i] = y(boxes[i].max.y);
    }
    // To the right of everything, where no box reaches.
    for (unsigned i = count; i < count + PADDING; ++i)
        min_x[i] = min_y[i] = max_x[i] = max_y[i] = LAST + 1;
}

}  // namespace detail

namespace {

constexpr unsigned FEW = 12;  // up to so many boxes vectors do not pay

// Up to so many boxes it is mostly faster than Sweep, measured on the paper's workload.
#if defined(__ARM_NEON)
constexpr unsigned MANY = 70;
#else
constexpr unsigned MANY = detail::ShortBoxes::CAPACITY;
#endif

// A vector with boxes that overlap box `box`: bit STRIDE * i stands for the box `other` + i.
struct Hit {
    std::uint64_t bits;  // not 0
    std::uint32_t box, other;
};

// A branch on whether a vector has a hit would often be mispredicted.  So hits are first stored
// without a branch, and split into pairs afterwards.
struct Hits {
    static constexpr unsigned PER_ROW = detail::ShortBoxes::CAPACITY / lanes::SHORTS;  // at most

    std::array<Hit, 8 * PER_ROW> all;
    unsigned count;
};

// Compares each box from `row` on with those after it.  Stops before `hits` could overflow.
// Returns the row to go on with, or `count` at the end.
unsigned compare_all(const detail::ShortBoxes& boxes, unsigned count, unsigned row, Hits& hits) {
    using lanes::Shorts;
    Hit* next = hits.all.data();
    const Hit* const last = next + hits.all.size() - Hits::PER_ROW;
    for (; row < count && next < last; ++row) {
        const Shorts min_x = boxes.min_x[row] - Shorts{}, max_x = boxes.max_x[row] - Shorts{};
        const Shorts min_y = boxes.min_y[row] - Shorts{}, max_y = boxes.max_y[row] - Shorts{};
        for (unsigned j = row + 1; j < count; j += lanes::SHORTS) {
            const Shorts apart = (lanes::load<Shorts>(&boxes.min_x[j]) > max_x) |
                                 (lanes::load<Shorts>(&boxes.max_x[j]) < min_x) |
                                 (lanes::load<Shorts>(&boxes.min_y[j]) > max_y) |
                                 (lanes::load<Shorts>(&boxes.max_y[j]) < min_y);
            const std::uint64_t bits = lanes::bits(~apart);
            *next = {bits, row, j};
            next += bits != 0;
        }
    }
    hits.count = static_cast<unsigned>(next - hits.all.data());
    return row;
}

// No branch: four comparisons.
bool overlap(const Aabb& a, const Aabb& b) {
    return (a.min.x <= b.max.x) & (b.min.x <= a.max.x) & (a.min.y <= b.max.y) &
           (b.min.y <= a.max.y);
}

}  // namespace

void Simd::find(const Aabb* boxes, unsigned count, PairList& overlaps) {
    if (count > MANY) return sweep_.find(boxes, count, overlaps);
    PairWriter pairs(overlaps);
    if (count <= FEW) {
        for (std::uint32_t row = 0; row < count; ++row) {
            pairs.need(count);
            for (std::uint32_t j = row + 1; j < count; ++j)
                pairs.append(row, j, overlap(boxes[row], boxes[j]));
        }
        return pairs.finish();
    }
    shorts_.assign(boxes, count);
    Hits hits;
    for (unsigned row = 0; row < count;) {
        row = compare_all(shorts_, count, row, hits);
        for (unsigned i = 0; i < hits.count; ++i) {
            const Hit& hit = hits.all[i];
            pairs.need(lanes::SHORTS);
            for (std::uint64_t bits = hit.bits; bits != 0; bits &= bits - 1) {
                const std::uint32_t other = hit.other + lanes::lowest_bit(bits) / lanes::STRIDE;
                // Rounding made boxes larger; this leaves out those that do not overlap.
                pairs.append(hit.box, other, overlap(boxes[hit.box], boxes[other]));
            }
        }
    }
    pairs.finish();
}

}  // namespace collision
