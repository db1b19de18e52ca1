// pair_room.cpp - see pair_room.h
#include "collision/broad/pair_room.h"

#include <algorithm>

#include "collision/broad/huge_pages.h"

namespace collision {

PairRoom PairRoom::larger(std::size_t places) const {
    const std::size_t written = used(), size = written + places;
    if (size > list_->capacity()) {
        PairList moved;
        reserve_in_huge_pages(moved, std::max(size, 2 * list_->size()));
        moved.assign(list_->begin(), list_->begin() + static_cast<std::ptrdiff_t>(written));
        list_->swap(moved);
    }
    list_->resize(size);
    PairRoom room(*list_);
    room.next += written;
    return room;
}

}  // namespace collision
