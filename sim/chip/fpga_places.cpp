#include "sim/chip/fpga_places.h"

#include <algorithm>

#include "regmap.h"

namespace sim {

std::map<std::uint32_t, std::string> fpga_registers() {
    std::map<std::uint32_t, std::string> names;
    for (const regmap::Reg& reg : regmap::REGS) names.emplace(reg.addr, reg.name);
    return names;
}

std::vector<Bus::Place> fpga_places(std::uint32_t base, std::uint32_t size) {
    std::vector<Bus::Place> places;
    for (const regmap::Block& block : regmap::BLOCKS) {
        if (block.base - base >= size) continue;
        const bool registers =
            std::any_of(std::begin(regmap::REGS), std::end(regmap::REGS),
                        [&](const regmap::Reg& reg) { return reg.addr - block.base < block.size; });
        places.push_back({block.name, block.base, block.size, !registers});
    }
    return places;
}

}  // namespace sim
