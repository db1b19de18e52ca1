// clock_manager.h - the HPS's clock manager, as the DE1-SoC's preloader leaves it
//
//   OSC1 25 MHz --+-- main PLL 1600 MHz ---- MPU 800, L3 400 and 200, L4_MAIN 400 MHz, ...
//                 +-- peripheral PLL 1000 -- L4_MP 100, L4_SP 100, USB 200, SPI masters 200, ...
//                 +-- SDRAM PLL 800 -------- DDR3 400
//
// All PLLs are locked, nothing is bypassed, and all clocks are on.  Registers and their writable
// bits are those of the chip.
//
// Sources: Cyclone V HPS TRM, chapter Clock Manager; the settings of the DE1-SoC's preloader
// (U-Boot, board/terasic/de1-soc).
//
// Not handled: what a write would do: the clocks stay as they are here.  changes_a_clock() is for
// those that would change a frequency on the board.
#pragma once

#include "sim/hps/register_table.h"

namespace sim::clock_manager {

std::vector<TableRegister> registers();

// The register at `offset` decides over a frequency, or whether there is a clock at all.
bool changes_a_clock(std::uint32_t offset);

}  // namespace sim::clock_manager
