// model.h - a design, Verilated and loaded: what its library offers to de1sim.
//
// The library is compiled beside the project from Verilator's output and runtime/design.cpp, and
// linked with runtime/model.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "sim/pins/pins.h"
#include "sim/pins/trace.h"

namespace sim::project {

// How the design has ended the run, if it has.
struct Ending {
    enum class Kind {
        NONE,
        FINISHED,  // $finish
        STOPPED,   // $stop, $error, $fatal
        DIVERGED   // signals that do not come to rest
    };
    Kind kind = Kind::NONE;
    std::string message;  // a line: where, what, when
};

// A burst over a bridge, as AXI3 has it: of the processor, or of another master that uses it.
struct BridgeBurst {
    static constexpr unsigned BEATS = 16, LANES = 16;
    struct Beat {
        std::uint32_t address;                  // of the bus's word
        std::uint16_t strobes;                  // of a read: the lanes that are wanted
        std::array<std::uint8_t, LANES> lanes;  // as far as the bus is wide; of a read, the answer
    };
    bool full;  // HPS-to-FPGA, or the lightweight bridge
    bool write;
    std::uint32_t address;           // in the bridge's window
    unsigned beats, size, kind;      // AxLEN + 1, AxSIZE, AxBURST
    unsigned id, lock, cache, prot;  // AxID, AxLOCK, AxCACHE, AxPROT
    unsigned error;                  // BRESP or RRESP: 1 EXOKAY, 2 SLVERR, 3 DECERR; else 0
    std::array<Beat, BEATS> beat;
};

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

// A peripheral of the processor's that has signals in the design.  Their bits, from 0 on:
//
//   kind         to the design                         from the design
//   UART         txd, dtr, rts, out1_n, out2_n         rxd, cts, dsr, dcd, ri
//   I2C          SCL and SDA are pulled low            SCL, SDA
//   SPI_MASTER   txd, sclk, ssi_oe_n, ss_0_n - ss_3_n  rxd
//   SPI_SLAVE    txd, ssi_oe_n                         rxd, ss_in_n, sclk
//   LOAN_IO      pins of GPIO0, 1 or 2: 28:0           levels 28:0, driven 57:29
//   DMA          acknowledgements 7:0                  requests 7:0, of single transfers 15:8
struct Peripheral {
    enum Kind { UART, I2C, SPI_MASTER, SPI_SLAVE, LOAN_IO, DMA } kind;
    unsigned number;
};

// The processor's side of those.
class ProcessorWires {
public:
    // The design has moved them, at that time.  May call Model::drive(), not at once.
    virtual void moved(Peripheral which, std::uint64_t levels, std::uint64_t time_ps) = 0;

protected:
    ~ProcessorWires() = default;
};

class Model {
public:
    virtual ~Model() = default;

    ChipInputs in;  // what the board puts on the pins, in its answers and its agenda's entries

    // Runs all clock edges and entries up to and with `until_ps`.  What moves at the outputs goes
    // to the PinListener, in order; a batch of video samples may come later, at flush().
    virtual void run(std::uint64_t until_ps) = 0;
    virtual void flush() = 0;

    // ---- The processor's side of a design that has it ----

    // Bits of a bridge's bus in the design; 0: nothing is behind it.
    virtual unsigned bridge_width(bool full) const = 0;
    // For what the last burst waits: "awready", "rvalid of word 2 of a burst of 8"; empty: not
    // known.
    virtual std::string waits_for() const = 0;
    // Begins a burst, at the time up to which run() has come; one at a time.
    virtual void begin(const BridgeBurst& burst) = 0;
    // h2f_reset begins or ends, at that time; of a cold reset h2f_cold_rst_n, too.
    virtual void reset(bool active, bool cold) = 0;
    // As run(), but ends with the clock edge that brings the answer; false: there is none so far.
    virtual bool run_to_answer(std::uint64_t until_ps) = 0;
    // The last burst, with what was read.
    virtual const BridgeBurst& answer() const = 0;
    // Interrupt lines; bit n is ID 72 + n.
    virtual std::uint64_t interrupts() const = 0;
    // Resets of the processor that the design asks for: bits of ResetRequest.
    enum ResetRequest : unsigned { COLD = 1, WARM = 2, DEBUG = 4 };
    virtual unsigned reset_requests() const = 0;
    // The general purpose signals: to the design, at that time; and from it.
    virtual void general_purpose(std::uint32_t signals) = 0;
    virtual std::uint32_t general_purpose() const = 0;
    // Whether the design has it.
    virtual bool has(Peripheral which) const = 0;
    // Calls `wires` with the levels that they have, and from now on with those that move.
    virtual void connect(ProcessorWires& wires) = 0;
    // Its signals to the design, at this time, up to which run() has come; nothing: while it runs,
    // after the present evaluation.  One that the design has not does nothing.
    virtual void drive(Peripheral which, std::uint64_t levels,
                       std::optional<std::uint64_t> time_ps) = 0;
    // Of the last clock edge, or of the last entry of the agenda.
    virtual std::uint64_t time_ps() const = 0;
    virtual void end_trace() = 0;
    // Once there is an end, run() does nothing any more.
    virtual const Ending& ending() const = 0;
};

struct ModelSettings {
    const char* folder;  // the project's: $readmemh and other files are opened from there
    Trace trace;
    void (*report)(const char* line);  // what a person should know
    JtagTerminals* terminals = nullptr;
    ProcessorMemory* memory = nullptr;  // null: there is no program
};

// `extern "C"` as de1sim_open_model; the caller deletes what it gets.
using OpenModel = Model*(PinListener& pins, const ModelSettings& settings);

}  // namespace sim::project
