// model.h - a design, Verilated and loaded: what its library gets, and how it is opened.
//
// The library is compiled beside the project from Verilator's output and runtime/design.cpp, and
// linked with runtime/model.cpp.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/pins/fpga_model.h"
#include "sim/pins/trace.h"

namespace sim::project {

// The terminals on the PC, of the design's JTAG UARTs, by their numbers.
class JtagTerminals {
public:
    virtual void sent(unsigned number, char character) = 0;
    virtual std::optional<char> typed(unsigned number) = 0;  // the next one, which is taken

protected:
    ~JtagTerminals() = default;
};

// What masters in the design reach: the processor's memory, and by fpga2hps its peripherals, too.
// Ports are 0 to 5, the command ports of fpga2sdram, and FPGA2HPS.
class ProcessorMemory {
public:
    static constexpr unsigned FPGA2HPS = 6, PORTS = 7;
    enum class Answer { DONE, NOBODY, PAST_THE_END };

    // Not held in reset.
    virtual bool is_open(unsigned port) const = 0;
    // Takes a burst, or a word of one, at the next clock: it is open, and the memory not behind.
    virtual bool takes(unsigned port, std::uint64_t now_ps) const = 0;
    // Begins a burst; returns when its first word is there, or when it is written.
    virtual std::uint64_t begin(unsigned bytes, std::uint64_t now_ps) = 0;
    // A word of it, or some bytes of a word.
    virtual Answer access(unsigned port, bool write, std::uint32_t address, std::uint8_t* data,
                          unsigned bytes, std::uint64_t now_ps) = 0;

protected:
    ~ProcessorMemory() = default;
};

struct ModelSettings {
    const char* folder;  // the project's: $readmemh and other files are opened from there
    Trace trace;
    void (*report)(const char* line);  // what a person should know
    JtagTerminals* terminals = nullptr;
    ProcessorMemory* memory = nullptr;  // null: there is no program
};

// `extern "C"` as de1sim_open_model; the caller deletes what it gets.
using OpenModel = FpgaModel*(PinListener& pins, const ModelSettings& settings);

}  // namespace sim::project
