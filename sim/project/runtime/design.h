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

class Design {
public:
    virtual ~Design() = default;

    virtual ChipPorts ports() = 0;  // valid as long as the design
    // After inputs have moved.  `now_ps` is what $time gives.  May throw Diverged (endings.h).
    virtual void eval(std::uint64_t now_ps) = 0;
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
    bool clock_50_seen;  // by anything but PLLs that are not locked
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
