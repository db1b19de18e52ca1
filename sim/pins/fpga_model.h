// fpga_model.h - what is in the FPGA, clock by clock: the seam to what gives it SystemC's time.
//
// Whoever implements this plays some Verilog: any design, with its pins as the board has them
// (sim/project/runtime), or this project's own, which leaves out the clocks in which nothing
// happens (sim/fpga).  It calls the PinListener when pins move.  FpgaChip runs it in SystemC's
// time, and FpgaBridges carry the processor's accesses to it (sim/chip).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "sim/pins/pins.h"

namespace sim {

// A burst over a bridge, as AXI3 has it: of the processor, or of another master that uses it.
struct BridgeBurst {
    static constexpr unsigned BEATS = 16, LANES = 16;
    enum Response { OKAY = 0, EXOKAY = 1, SLVERR = 2, DECERR = 3 };
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
    unsigned error;                  // BRESP or RRESP if it is not OKAY: a Response
    std::array<Beat, BEATS> beat;
    bool posted = false;  // a write for whose answer nobody waits
};

// A peripheral of the processor's that has signals in the FPGA.  Their bits, from 0 on:
//
//   kind         to the FPGA                           from the FPGA
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
    // The FPGA has moved them, at that time.  May call FpgaModel::drive(), not at once.
    virtual void moved(Peripheral which, std::uint64_t levels, std::uint64_t time_ps) = 0;

protected:
    ~ProcessorWires() = default;
};

class FpgaModel {
public:
    virtual ~FpgaModel() = default;

    ChipInputs in;  // what the board puts on the pins, in its answers and its agenda's entries

    // Runs all clock edges and entries up to and with `until_ps`.  What moves at the outputs goes
    // to the PinListener, in order; a batch of video samples may come later, at flush().
    virtual void run(std::uint64_t until_ps) = 0;
    virtual void flush() = 0;
    // Of the last clock edge, or of the last entry of the agenda.
    virtual std::uint64_t time_ps() const = 0;
    virtual void end_trace() = 0;

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
    // Once there is an end, run() does nothing any more.
    virtual Ending ending() const { return {}; }

    // ---- The bridges ----

    // Bits of a bridge's bus in the FPGA; 0: nothing is behind it.
    virtual unsigned bridge_width(bool full) const = 0;
    // Begins a burst, at the time up to which run() has come; one at a time, but for posted writes.
    virtual void begin(const BridgeBurst& burst) = 0;
    // As run(), but ends with the clock edge that brings the answer; false: there is none so far.
    virtual bool run_to_answer(std::uint64_t until_ps) = 0;
    // The last burst, with what was read.
    virtual const BridgeBurst& answer() const = 0;
    // For what the last burst waits: "awready", "rvalid of word 2 of a burst of 8"; empty: not
    // known.
    virtual std::string waits_for() const { return {}; }

    // Whether a burst may be posted.  Posted writes follow each other without an answer, and may be
    // answered in any order; nothing else is begun before the last of them is answered.
    virtual bool takes_posted() const { return false; }
    // The oldest that is not answered, or nullptr; and whether one of this ID is not.
    virtual const BridgeBurst* posted() const { return nullptr; }
    virtual bool has_posted(unsigned /*id*/) const { return false; }
    // As run(), but ends with the clock edge that leaves `most` of them; false: there are more.
    virtual bool run_to_posted(std::uint64_t /*until_ps*/, unsigned /*most*/) { return true; }
    // One whose answer is an error; each is given once.
    virtual std::optional<BridgeBurst> refused() { return {}; }

    // ---- The processor's other signals; those that a design has not do nothing ----

    // Interrupt lines; bit n is ID 72 + n.
    virtual std::uint64_t interrupts() const = 0;
    // h2f_reset begins or ends, at that time; of a cold reset h2f_cold_rst_n, too.
    virtual void reset(bool /*active*/, bool /*cold*/) {}
    // Resets of the processor that the design asks for: bits of ResetRequest.
    enum ResetRequest : unsigned { COLD = 1, WARM = 2, DEBUG = 4 };
    virtual unsigned reset_requests() const { return 0; }
    // The general purpose signals: to the design, at that time; and from it.
    virtual void general_purpose(std::uint32_t /*signals*/) {}
    virtual std::uint32_t general_purpose() const { return 0; }
    // Whether the design has it.
    virtual bool has(Peripheral /*which*/) const { return false; }
    // Calls `wires` with the levels that they have, and from now on with those that move.
    virtual void connect(ProcessorWires& /*wires*/) {}
    // Its signals to the design, at this time, up to which run() has come; nothing: while it runs,
    // after the present evaluation.
    virtual void drive(Peripheral /*which*/, std::uint64_t /*levels*/,
                       std::optional<std::uint64_t> /*time_ps*/) {}

    // ---- What a model may offer so that clocks and accesses cost no work ----

    // Reads or writes bytes of a memory behind a bridge from `begin_ps` on without the bridge.
    // Returns when the bridge would have been done if nothing held it up; nothing: not offered
    // there.
    virtual std::optional<std::uint64_t> access_memory(bool /*full*/, bool /*write*/,
                                                       std::uint32_t /*address*/,
                                                       std::uint8_t* /*data*/, unsigned /*bytes*/,
                                                       std::uint64_t /*begin_ps*/) {
        return {};
    }
    // A memory that may be read directly, and written if `may_be_written`, from `first` to `last`.
    struct DirectMemory {
        std::uint8_t* bytes;
        std::uint32_t first, last;  // in the bridge's window
        bool may_be_written;
    };
    // That at an address; nothing: not offered there.
    virtual std::optional<DirectMemory> direct_memory(bool /*full*/,
                                                      std::uint32_t /*address*/) const {
        return {};
    }
    // As long as this stays the same, a register that was read gives the same again, unless the
    // processor has written, or reading has a side effect.  An access of so many clocks may leave
    // it as it is.
    static constexpr unsigned LONGEST_ACCESS = 12;
    virtual std::uint64_t changes() const { return 0; }
    // In so many ps from now on no register changes, if nobody accesses one and no input moves.
    // May be too low: 0 where this is not known.
    virtual std::uint64_t calm_ps() const { return 0; }
};

}  // namespace sim
