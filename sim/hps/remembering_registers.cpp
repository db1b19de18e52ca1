#include "sim/hps/remembering_registers.h"

namespace sim::remembering {

// ARM DDI 0407G, 2.2.2: two processors, neither in SMP, tag RAMs of 32 KB caches.
std::vector<FixedRegisters> scu() { return {{0x04, 0x04, 0x00000501}}; }

// ARM DDI 0246F: cache ID (r3p3, as Linux reports it of a Cyclone V), cache type; maintenance is
// complete at once: the operations' busy bits read 0.
std::vector<FixedRegisters> l2_cache() {
    return {{0x000, 0x000, 0x410030C9}, {0x004, 0x004, 0x1C300300}, {0x730, 0x7FC, 0}};
}

// After reset: 8 ways of 64 KB, the RAMs at their greatest latency; and the filter by which the
// preloader gives addresses from 0 on to the DDR3.
std::map<std::uint32_t, std::uint32_t> l2_cache_after_preloader() {
    constexpr std::uint32_t AUX_CONTROL = 0x104, TAG_RAM = 0x108, DATA_RAM = 0x10C,
                            FILTER_START = 0xC00, FILTER_END = 0xC04;
    return {{AUX_CONTROL, 0x02060000},
            {TAG_RAM, 0x777},
            {DATA_RAM, 0x777},
            {FILTER_START, 1},
            {FILTER_END, 0xC0000000}};
}

// Cyclone V HPS TRM, siliconid1: a Cyclone V, first revision.
std::vector<FixedRegisters> system_manager() { return {{0x00, 0x00, 0x00000001}}; }

// Cyclone V HPS TRM, SDRAM Controller Subsystem: dramsts says that the calibration has succeeded.
std::vector<FixedRegisters> sdram_control() { return {{0x5038, 0x5038, 0x00000001}}; }

// The DE1-SoC's preloader: DDR3, bursts of 8; 10 columns, 15 rows, 3 banks, one chip select; 32
// bits.
std::map<std::uint32_t, std::uint32_t> sdram_after_preloader() {
    constexpr std::uint32_t CTRLCFG = 0x5000, DRAMADDRW = 0x502C, DRAMIFWIDTH = 0x5030,
                            FPGAPORTRST = 0x5080;  // all of the FPGA's ports are out of reset
    return {
        {CTRLCFG, 0x000A8042}, {DRAMADDRW, 0x00002DEA}, {DRAMIFWIDTH, 32}, {FPGAPORTRST, 0x3FFF}};
}

// Cyclone V HPS TRM, Scan Manager: stat is 0, not active and no byte in its FIFOs.
std::vector<FixedRegisters> scan_manager() { return {{0x00, 0x00, 0}}; }

}  // namespace sim::remembering
