// simd.cpp - see broad_phase.h
#include <algorithm>
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

constexpr unsigned FEW = 12;          // up to so many boxes vectors do not pay
constexpr unsigned MOST_IN_HIT = 16;  // lanes

// No branch: four comparisons.
bool overlap(const Aabb& a, const Aabb& b) {
    return (a.min.x <= b.max.x) & (b.min.x <= a.max.x) & (a.min.y <= b.max.y) &
           (b.min.y <= a.max.y);
}

}  // namespace

void Simd::find(const Aabb* boxes, unsigned count, PairList& overlaps) {
    if (count > kernels_->brute_force_up_to) return strips_.find(boxes, count, overlaps);
    detail::PairWriter pairs(overlaps);
    if (count <= FEW) {
        for (std::uint32_t row = 0; row < count; ++row) {
            pairs.need(count);
            for (std::uint32_t j = row + 1; j < count; ++j)
                pairs.append(row, j, overlap(boxes[row], boxes[j]));
        }
        return pairs.finish();
    }
    shorts_.assign(boxes, count);
    for (unsigned row = 0; row < count;) {
        row = kernels_->compare_all(shorts_, count, row, hits_);
        for (unsigned i = 0; i < hits_.count; ++i) {
            const detail::ShortHit& hit = hits_.hits[i];
            pairs.need(MOST_IN_HIT);
            for (std::uint64_t bits = hit.bits; bits != 0; bits &= bits - 1) {
                const std::uint32_t other =
                    hit.other + detail::lanes::lowest_bit(bits) / hits_.stride;
                // Rounding made boxes larger; this leaves out those that do not overlap.
                pairs.append(hit.box, other, overlap(boxes[hit.box], boxes[other]));
            }
        }
    }
    pairs.finish();
}

}  // namespace collision
