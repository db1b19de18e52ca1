#include "sim/board/fpga_places.h"

#include "regmap.h"

namespace sim {

std::vector<Bus::Place> fpga_places(std::uint32_t base, std::uint32_t size) {
    std::vector<Bus::Place> places;
    for (const regmap::Block& block : regmap::BLOCKS)
        if (block.base - base < size) places.push_back({block.name, block.base, block.size});
    return places;
}

}  // namespace sim
