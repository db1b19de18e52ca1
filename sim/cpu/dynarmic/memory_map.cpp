#include "sim/cpu/dynarmic/memory_map.h"

#include <algorithm>

namespace sim {

void MemoryMap::remove(std::uint32_t base) {
    areas_.erase(std::remove_if(areas_.begin(), areas_.end(),
                                [base](const Area& area) { return area.base == base; }),
                 areas_.end());
    last_ = 0;
}

const MemoryMap::Area* MemoryMap::find(std::uint32_t address) const {
    if (last_ < areas_.size() && areas_[last_].contains(address)) return &areas_[last_];
    for (std::size_t i = 0; i < areas_.size(); ++i) {
        if (!areas_[i].contains(address)) continue;
        last_ = i;
        return &areas_[i];
    }
    return nullptr;
}

std::uint8_t* MemoryMap::ram(std::uint32_t address, std::size_t bytes) const {
    const Area* const area = find(address);
    if (!area || !area->bytes) return nullptr;
    const std::uint32_t offset = address - area->base;
    return bytes <= area->size - offset ? area->bytes + offset : nullptr;
}

}  // namespace sim
