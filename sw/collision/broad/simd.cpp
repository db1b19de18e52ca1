// simd.cpp - see simd.h
#include "collision/broad/simd.h"

namespace collision {

void Simd::find(const Aabb* boxes, unsigned count, PairList& overlaps) {
    if (count > CAPACITY) return sweep_.find(boxes, count, overlaps);
    shorts_.assign(boxes, count);
    unsigned row = 0;
    fill_list(overlaps, count, [&](PairRoom& room) {
        row = kernels_->short_rows(shorts_, boxes, count, row, room);
        return row == count;
    });
}

}  // namespace collision
