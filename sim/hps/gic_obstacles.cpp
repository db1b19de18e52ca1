// gic_obstacles.cpp - why the interrupt controller keeps an interrupt from the processor, in words
#include <fmt/format.h>

#include "sim/hps/gic.h"

namespace sim {

namespace {

constexpr std::uint32_t ENABLES = 0xFFFED100, TARGETS = 0xFFFED800;  // ICDISER, ICDIPTR
constexpr std::uint8_t CPU0_BIT = 1;

}  // namespace

std::vector<std::string> GicState::obstacles(unsigned id) const {
    std::vector<std::string> all;
    if (!enabled[id])
        all.push_back(fmt::format("its bit {} of ICDISER{} (0x{:08X}) is 0", id % 32, id / 32,
                                  ENABLES + id / 32 * 4));
    const unsigned bit = non_secure[id] ? 1 : 0;
    if (!(non_secure[id] ? distribute_non_secure : distribute_secure))
        all.push_back(fmt::format("bit {} of ICDDCR (0xFFFED000) is 0", bit));
    if (!(control >> bit & 1))
        all.push_back(fmt::format("bit {} of ICCICR (0xFFFEC100) is 0", bit));
    if (non_secure[id] && (!distribute_non_secure || !(control & 2)))
        all.push_back("ICDISR makes it Non-secure");
    else if (non_secure[id] && !(control & 4))
        all.push_back("ICDISR makes it Non-secure: ICCIAR reads 1022 while bit 2 of ICCICR is 0");
    if (!(targets[id] & CPU0_BIT))
        all.push_back(fmt::format("byte 0x{:08X} of ICDIPTR is 0x{:02X}: CPU0 is not its target",
                                  TARGETS + id, targets[id]));
    if (priority[id] >= mask)
        all.push_back(fmt::format(
            "ICCPMR (0xFFFEC104) is 0x{:02X}, which keeps its priority of 0x{:02X} back", mask,
            priority[id]));
    for (const unsigned other : running_)
        if (other == id || group(priority[id]) >= group(priority[other]))
            all.push_back(fmt::format(
                "interrupt {} is still active: ICCEOIR (0xFFFEC110) was not written", other));
    return all;
}

}  // namespace sim
