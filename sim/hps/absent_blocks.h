// absent_blocks.h - blocks of the HPS that the simulation does not have, by name and address.
//
// Source: Cyclone V HPS memory map (cv_5v4, address map for HPS).
#pragma once

#include <vector>

#include "sim/hps/bus.h"

namespace sim {

inline std::vector<Bus::Place> absent_blocks() {
    return {
        {"the trace module STM", 0xFC000000, 0x3000000},
        {"the debug access port", 0xFF000000, 0x200000},
        {"the registers of the lightweight bridge", 0xFF400000, 0x100000},
        {"the registers of the HPS-to-FPGA bridge", 0xFF500000, 0x100000},
        {"the registers of the FPGA-to-HPS bridge", 0xFF600000, 0x100000},
        {"Ethernet, EMAC0", 0xFF700000, 0x2000},
        {"Ethernet, EMAC1", 0xFF702000, 0x2000},
        {"the SD card's controller", 0xFF704000, 0x1000},
        {"the QSPI flash's controller", 0xFF705000, 0x1000},
        {"the ACP's mapper", 0xFF707000, 0x1000},
        {"the NAND flash", 0xFF900000, 0x100000},
        {"the QSPI flash", 0xFFA00000, 0x100000},
        {"USB0", 0xFFB00000, 0x40000},
        {"USB1", 0xFFB40000, 0x40000},
        {"the NAND flash's controller", 0xFFB80000, 0x10000},
        {"the FPGA manager's data port", 0xFFB90000, 0x1000},
        {"CAN0", 0xFFC00000, 0x1000},
        {"CAN1", 0xFFC01000, 0x1000},
        {"the DMA controller's registers of the non-secure state", 0xFFE00000, 0x1000},
        {"the boot ROM", 0xFFFD0000, 0x10000},
    };
}

}  // namespace sim
