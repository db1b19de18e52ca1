#include "sim/hps/clock_manager.h"

namespace sim::clock_manager {

namespace {

constexpr std::uint32_t MAIN = 0x40, PERIPHERAL = 0x80, SDRAM = 0xC0, MISC = 0xE0;
constexpr std::uint32_t COUNT = 0x1FF, COUNT_AND_PHASE = 0x1FFFFF;

// VCO: the oscillator times numerator + 1, over denominator + 1; on, powered, counters running.
constexpr std::uint32_t vco(std::uint32_t numerator) { return numerator << 3 | 2; }
constexpr std::uint32_t VCO_BITS = 0x83FFFFFF, BANDWIDTH = 0x4002, BANDWIDTH_BITS = 0x7FFF;

}  // namespace

std::vector<TableRegister> registers() {
    return {
        {0x00, 0x00000004, 0x4, 0x1},      // ctl: not in safe mode
        {0x04, 0x00000000, 0x1F},          // bypass
        {0x08, 0x000001C7, 0x0, 0x3F},     // inter: the three PLLs are locked, and were achieved
        {0x0C, 0x00000000, 0x3F},          // intren
        {0x10, 0x00000001, 0x5},           // dbctl
        {0x14, 0x00000000, 0x0},           // stat: not busy
        {MAIN + 0x00, vco(63), VCO_BITS},  // 1600 MHz
        {MAIN + 0x04, BANDWIDTH, BANDWIDTH_BITS},
        {MAIN + 0x08, 0, COUNT},                 // MPU
        {MAIN + 0x0C, 0, COUNT},                 // main
        {MAIN + 0x10, 0, COUNT},                 // debug
        {MAIN + 0x14, 3, COUNT},                 // QSPI
        {MAIN + 0x18, 511, COUNT},               // NAND, SD card
        {MAIN + 0x1C, 15, COUNT},                // user 0
        {MAIN + 0x20, 0x3FF, 0x3FF},             // en
        {MAIN + 0x24, 0x095, 0x3FF},             // maindiv: L3 MP 2, L3 SP 2, L4 MP 2, L4 SP 2
        {MAIN + 0x28, 0x004, 0xF},               // dbgdiv
        {MAIN + 0x2C, 0x000, 0x7},               // tracediv
        {MAIN + 0x30, 0x003, 0x3},               // l4src: both of the peripheral PLL
        {MAIN + 0x34, 0, 0},                     // stat
        {PERIPHERAL + 0x00, vco(39), VCO_BITS},  // 1000 MHz
        {PERIPHERAL + 0x04, BANDWIDTH, BANDWIDTH_BITS},
        {PERIPHERAL + 0x08, 511, COUNT},      // EMAC0
        {PERIPHERAL + 0x0C, 3, COUNT},        // EMAC1
        {PERIPHERAL + 0x10, 511, COUNT},      // QSPI
        {PERIPHERAL + 0x14, 4, COUNT},        // NAND, SD card
        {PERIPHERAL + 0x18, 4, COUNT},        // base: 200 MHz
        {PERIPHERAL + 0x1C, 511, COUNT},      // user 1
        {PERIPHERAL + 0x20, 0xFFF, 0xFFF},    // en
        {PERIPHERAL + 0x24, 0x900, 0xFFF},    // div: USB 1, SPI masters 1, CAN 16
        {PERIPHERAL + 0x28, 6249, 0xFFFFFF},  // gpiodiv: 32 kHz
        {PERIPHERAL + 0x2C, 0x01A, 0x3F},     // src
        {PERIPHERAL + 0x30, 0, 0},            // stat
        {SDRAM + 0x00, vco(31), 0x83FFFFFF},  // 800 MHz
        {SDRAM + 0x04, BANDWIDTH, BANDWIDTH_BITS},
        {SDRAM + 0x08, 0x001, COUNT_AND_PHASE},  // DQS
        {SDRAM + 0x0C, 0x000, COUNT_AND_PHASE},  // 2 x DQS
        {SDRAM + 0x10, 0x801, COUNT_AND_PHASE},  // DQ
        {SDRAM + 0x14, 0x005, COUNT_AND_PHASE},  // user 2
        {SDRAM + 0x18, 0xF, 0xF},                // en
        {SDRAM + 0x1C, 0, 0},                    // stat
        {MISC + 0x00, 1, COUNT},                 // MPU: over 2
        {MISC + 0x04, 3, COUNT},                 // main: over 4
        {MISC + 0x08, 3, COUNT},                 // debug: over 4
    };
}

bool changes_a_clock(std::uint32_t offset) {
    return offset == 0x04 || (offset >= MAIN && offset != MAIN + 0x04 &&
                              offset != PERIPHERAL + 0x04 && offset != SDRAM + 0x04);
}

}  // namespace sim::clock_manager
