// design.h - a design, Verilated: its pins as de1sim_chip.v has them, and what is known of it.
//
// design.cpp, which is compiled with each design, offers this; model.cpp, which is compiled once,
// plays it.  Neither Verilator's headers nor the board's parts are needed, so that designs compile
// fast.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "sim/pins/chip_wires.h"

namespace sim {
class FpgaModel;
class PinListener;
}  // namespace sim

namespace sim::project {

struct ModelSettings;

// The ports of de1sim_chip.v.
struct ChipPorts {
#define CHIP_PORT(name, kind, bits) PortWord<bits_of(ChipPort::name)>& name;
#include "sim/pins/chip_wires.def"
};

// Outputs of de1sim_chip.v, for those who take what was there before a clock rose, or are notified
// of what has moved.
struct PinLevels {
    std::uint32_t vga = 0, dram = 0, clocks = 0;  // before the last evaluation; clocks after it
    std::uint16_t dram_dq = 0;
    std::uint32_t pins = 0, ledr = 0;  // that the board has been notified of, to the end
    std::uint64_t hex_n = ~std::uint64_t{0};
#define CHIP_HEADER(wire, port) std::uint64_t port = 0;
#include "sim/pins/chip_wires.def"
};

template <class Chip>
void note_levels(PinLevels& levels, const Chip& chip) {
    levels.vga = chip.vga_o;
    levels.dram = chip.dram_o;
    levels.dram_dq = chip.dram_dq_o;
}

template <class Chip>
void take_headers(PinLevels& levels, const Chip& chip) {
#define CHIP_HEADER(wire, port) levels.port = chip.port##_o;
#include "sim/pins/chip_wires.def"
}

// Not 0: others than the board has been notified of.  One decision where nothing has moved, as at
// most edges.
template <class Chip>
std::uint64_t moved(const PinLevels& levels, const Chip& chip) {
    std::uint64_t all =
        (levels.pins ^ chip.pins_o) | (levels.hex_n ^ chip.hex_no) | (levels.ledr ^ chip.ledr_o);
#define CHIP_HEADER(wire, port) all |= levels.port ^ chip.port##_o;
#include "sim/pins/chip_wires.def"
    return all;
}

class Design {
public:
    virtual ~Design() = default;

    virtual ChipPorts ports() = 0;  // valid as long as the design
    // After inputs have moved: notes `levels`, evaluates, and returns moved() after that.  `now_ps`
    // is what $time gives.  May throw Diverged (endings.h).
    virtual std::uint64_t eval(std::uint64_t now_ps, PinLevels& levels) = 0;
    virtual void final() = 0;

    // Waveforms, in FST; false, and nothing is done, in a design that was compiled without.
    virtual bool begin_trace(const std::string& file) = 0;
    virtual void dump(std::uint64_t time_ps) = 0;
    virtual void end_trace() = 0;
};

struct PllTimes {
    std::uint64_t period_fs, phase_fs, high_fs;
    unsigned pins;    // bits of clocks_o, if it drives these alone; else 0
    bool only_rises;  // nothing sees its fall
    bool is_seen;     // by anything
};

// A UART of the processor's, at the place of this number.
struct PlacedUart {
    const char* instance;
    unsigned number;
};

struct DesignFacts {
    const PllTimes* pll_clocks;
    unsigned pll_clock_count;
    bool pulses;  // a change of a clock that only rises is a pulse, else its falls have to come
    bool clock_50_only_rises;
    bool clock_50_seen;      // by anything but PLLs that are not locked
    unsigned clock_50_pins;  // bits of clocks_o that rise with it
    bool td_clk27_used, vga_used, aud_xck_used, aud_clocks_driven;
    const char* const* source_folders;  // from the project's on, for init files
    unsigned source_folder_count;
    const PlacedUart* placed_uarts;  // up to one without a name
    const char* loops;               // signals that depend on themselves; "": none
};

// The caller deletes it.
FpgaModel* play(std::unique_ptr<Design> design, const DesignFacts& facts, PinListener& pins,
                const ModelSettings& settings);

}  // namespace sim::project
