// simd.cpp - see simd.h
#include "collision/broad/simd.h"

namespace collision {

void Simd::find(const Aabb* boxes, unsigned count, PairList& overlaps) {
    if (count > CAPACITY) return strips_.find(boxes, count, overlaps);
    shorts_.assign(boxes, count);
    unsigned row = 0;
    PairWriter writer(overlaps);
    writer.write(count, [&](PairRoom& room) {
        row = kernels_->short_rows(shorts_, boxes, count, row, room);
        return row == count;
    });
    writer.finish();
}

}  // namespace collision
