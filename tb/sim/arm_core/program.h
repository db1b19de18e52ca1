// program.h - random programs of basic blocks that branch to, call and return to each other for
// ever, with loads and stores from RAM, from the bus and from both at once.
#pragma once

#include <cstdint>
#include <vector>

#include "tb/sim/arm_core/maker.h"

namespace tb::core {

struct Program {
    bool thumb;
    // low_any: on the bus, or in RAM; high_any: at the end of RAM, followed by the bus
    Registers registers;
    std::vector<std::uint16_t> code;
    std::vector<std::uint32_t> blocks;  // addresses; the first is the entry
};

struct ProgramKind {
    bool thumb, bus, it_blocks, stops;  // `stops`: SVC, WFI and WFE
};

Program make_program(Random& random, const ProgramKind& kind, std::uint32_t address);

}  // namespace tb::core
