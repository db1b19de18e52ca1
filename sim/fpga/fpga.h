// fpga.h - the fabric behind TLM: two bridges as targets, catching up with SystemC time in batches.
//
//   lw   lightweight bridge, offsets in 2 MB        one TLM transaction becomes AXI bursts of up to
//   h2f  full bridge, offsets in 960 MB             16 words, none across 4 KB
//
// The fabric runs when somebody looks: at every bus access, at every entry of the board's agenda,
// and once per scan line; then the listener is notified of the picture, so a frame's end does not
// depend on accesses.  A transaction's delay is what its clocks took.  It blocks: where its
// clocks come to the time of an event of SystemC, that comes first, and a long one lets SystemC
// catch up between its bursts.  So what a process enters into the agenda finds the fabric at the
// process's time.
//
// Each entry of the agenda is an event of SystemC, too, past which a processor does not run ahead.
//
// Interrupts are levels, notified when the fabric has caught up with their change: at once when a
// transaction makes it, else within a scan line (32 us).
//
// Memory::MAPPED: the memories behind the full bridge, the SDRAM chip and the on-chip memory, are
// reached without the bridge's Verilog, since a program that draws pixel by pixel would spend all
// its time there.  There is one storage, so the screen sees the same, up to a scan line sooner: the
// fabric does not catch up for it.  A transaction takes the time that the bridge takes while
// nothing holds it up.  The SDRAM also grants direct access (DMI), which takes none.
//
// What video-in writes lies in the same storage.  Instructions that were translated before it wrote
// over them are not translated again, as the real processor's caches would not hear of it either.
//
// Memory::BRIDGED: every access goes through the Verilog; the SDRAM grants direct access for
// instructions alone.
//
// Phase: the processor's clocks and the fabric's come from two oscillators on the board, here from
// one.  What the fabric's clock quantises - an answer, by 40 ns, and the catching up once a scan
// line - so reaches the processor up to half a clock earlier or later, by a hash of the number of
// such meetings and of the seed: evenly spread over the clock, and the same in every run.
//
// A response other than OKAY ends the transaction: DECERR is TLM_ADDRESS_ERROR, SLVERR is
// TLM_GENERIC_ERROR, no answer in 10,000 clocks is TLM_INCOMPLETE.  A write for which a block takes
// longer, as the PS/2 port does for a byte, waits while SystemC's time goes on, up to 100 ms.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "sim/fpga/fabric.h"

#include <systemc>
#include <tlm>
#include <tlm_utils/simple_target_socket.h>

namespace sim {

class Fpga : public sc_core::sc_module {
public:
    tlm_utils::simple_target_socket<Fpga> lw, h2f;

    enum class Memory { MAPPED, BRIDGED };

    // `sdram`: the chip's 64 MB.
    Fpga(const sc_core::sc_module_name& name, PinListener& pins, const Trace& trace,
         Memory memory = Memory::BRIDGED, std::uint8_t* sdram = nullptr,
         unsigned audio_rate = 8'000);
    ~Fpga() override;

    // Spreads the phases from now on; before, all are in the middle of the fabric's clock.
    void spread_phases(std::uint64_t seed) { seed_ = seed; }

    // `notify` is called with Fabric::irq() whenever it has changed.
    void on_interrupts(std::function<void(std::uint64_t levels)> notify) {
        notify_ = std::move(notify);
    }

    // The input pins, for the board's answers and entries.
    ChipInputs& inputs() { return fabric_.in; }
    // The host's side of the JTAG UARTs, as of now: the fabric has caught up when this returns.
    JtagInputs& jtag();
    void on_jtag_byte(Fabric::JtagSent sent) { fabric_.on_jtag_byte(std::move(sent)); }
    // Everything up to now has been run and handed to the listener.
    void catch_up();

    // A register on the lightweight bridge, read outside simulated time once the run is over.
    std::optional<std::uint32_t> peek(std::uint32_t offset);

    // The same for `count` bytes on the full bridge, one AXI burst.  False: nobody answers.
    bool peek_full(std::uint32_t offset, std::uint8_t* bytes, unsigned count);

    // As long as this stays the same, a register that was read gives the same again, unless the
    // processor has written, or reading has a side effect.
    std::uint64_t changes() const { return fabric_.changes(); }
    // Makes an access to a register that answers as it did before, in no work: the same time passes
    // as by transport(), in ps of SystemC's time.  Nothing if it may answer otherwise.
    std::optional<std::uint64_t> again(bool write, std::uint64_t begin_ps);

    // The on-chip memory's 256 KB, in no time; nothing in a build whose fabric cannot.
    void write_onchip(std::uint32_t offset, const std::uint8_t* data, unsigned bytes) {
        fabric_.write_onchip(offset, data, bytes);
    }

    void end_trace() { fabric_.end_trace(); }

    // Lets the transaction under way end, as SystemC's time goes on, and begins no other: the next
    // initiator waits for ever.  No peek() while a transaction is under way.
    void close() { closed_ = true; }
    bool is_busy() const { return busy_; }

    const Fabric& fabric() const { return fabric_; }

private:
    void lightweight_transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay);
    void full_transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay);
    void transport(Bridge bridge, tlm::tlm_generic_payload& tx, sc_core::sc_time& delay);
    bool direct_memory(tlm::tlm_generic_payload& tx, tlm::tlm_dmi& dmi);
    std::uint64_t mapped(bool write, std::uint32_t address, std::uint8_t* data, unsigned bytes);
    void run_to(const sc_core::sc_time& time);
    void scan_line();
    void board_moves();
    void wait_for_board(std::uint64_t next_ps);
    std::uint64_t let_others_go();
    void notify_interrupts();
    std::uint64_t start_of(std::uint64_t time_ps) const;
    std::uint64_t phase_ps();

    PinListener& pins_;
    Fabric fabric_;
    const Fabric::Met others_go_{[this] { return let_others_go(); }};
    sc_core::sc_event board_moves_;
    const Memory memory_;
    std::uint8_t* const sdram_;
    std::optional<std::uint64_t> seed_;
    std::uint64_t meetings_ = 0;      // of the two clocks
    std::uint64_t busy_until_ = 0;    // a clock, by accesses that were made again
    std::uint64_t calm_until_ = 0;    // a clock
    std::uint64_t took_[2] = {0, 0};  // clocks: the last read of a register, the last write
    std::function<void(std::uint64_t)> notify_ = [](std::uint64_t) {};
    std::uint64_t irq_ = 0;
    bool busy_ = false, closed_ = false;
    sc_core::sc_event never_;
};

}  // namespace sim
