// simd.cpp - see simd.h
#include "collision/broad/simd.h"

#include "collision/broad/overlap.h"

namespace collision {

void Simd::find(const Aabb* boxes, unsigned count, PairList& overlaps) {
    if (count > CAPACITY) return strips_.find(boxes, count, overlaps);
    PairRoom room(overlaps);
    if (count <= FEW) {
        for (std::uint32_t row = 0; row < count; ++row) {
            room.need(count);
            for (std::uint32_t j = row + 1; j < count; ++j)
                room.append(row, j, overlap(boxes[row], boxes[j]));
        }
        return room.finish();
    }
    shorts_.assign(boxes, count);
    for (unsigned row = 0; row < count;) {
        row = kernels_->short_rows(shorts_, count, row, hits_);
        for (unsigned hit = 0; hit < hits_.count; ++hit) {
            room.need(MOST_IN_HIT);
            append(boxes, hits_.hits[hit], room);
        }
    }
    room.finish();
}

// Rounding made boxes larger, so that those that are really apart are left out here.
void Simd::append(const Aabb* boxes, const ShortHit& hit, PairRoom& room) const {
    for (std::uint64_t bits = hit.bits; bits != 0; bits &= bits - 1) {
        const std::uint32_t other = hit.other + lanes::lowest_bit(bits) / hits_.stride;
        room.append(hit.box, other, overlap(boxes[hit.box], boxes[other]));
    }
}

}  // namespace collision
