#include "sim/board/fpga_places.h"

#include "regmap.h"

namespace sim {

namespace {

constexpr std::uint32_t SDRAM_SIZE = 0x04000000;  // on the board, from PICTURE1 on

}  // namespace

std::vector<Bus::Place> fpga_places(std::uint32_t base, std::uint32_t size) {
    std::vector<Bus::Place> places;
    for (const regmap::Block& block : regmap::BLOCKS) {
        if (block.base - base >= size) continue;
        places.push_back({block.name, block.base, block.size});
        if (block.base == regmap::PICTURE1_BASE)
            places.back().of = "the FPGA's SDRAM", places.back().extent = SDRAM_SIZE;
    }
    return places;
}

}  // namespace sim
