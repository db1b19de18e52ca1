// cells.cpp - see cells.h
#include "collision/broad/cells.h"

namespace collision {

bool Cells::count(const Kernels& kernels, const BoxList& list, const GridParts& parts) {
    parts_ = parts;
    if (cells_.size() < list.count + BOX_CELLS_SLACK) {
        cells_.resize(list.count + BOX_CELLS_SLACK);
        tall_.resize(list.count + BOX_CELLS_SLACK);
    }
    tall_count_ = kernels.box_cells(list, parts, cells_.data(), tall_.data());
    if (above_.size() < tall_count_) above_.resize(tall_count_ + tall_count_ / 8);
    std::uint64_t visitors = 0;
    for (unsigned k = 0; k < tall_count_; ++k) {
        above_[k] = strips_above(list.box(tall_[k]));
        visitors += above_[k];
    }
    if (visitors > MOST_COPIES * std::uint64_t{list.count}) return false;
    entries_ = list.count + static_cast<unsigned>(visitors);

    counts_.assign(parts.cells(), 0);
    std::uint32_t* counts = counts_.data();
    const auto add = [counts](unsigned, std::uint32_t cell) { ++counts[cell]; };
    deal(list, add, add);
    return true;
}

}  // namespace collision
