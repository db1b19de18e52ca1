// fpga_bridges.h - the processor's bridges into the FPGA, behind TLM
//
//   lw   lightweight bridge, offsets in 2 MB        h2f   full bridge, offsets in 960 MB
//
// A transaction becomes bursts, one after the other, each as long as the FPGA takes for it; its
// delay is what they take.  The FPGA runs up to the burst's time before.  A transaction blocks:
// where its clocks come to the time of an event of SystemC, that comes first.  So what a process
// enters into the board's agenda finds the FPGA at the process's time.
//
// A memory that the model offers without its bridge is reached so, and takes the time that the
// bridge takes while nothing holds it up; the FPGA does not catch up for it.  Where the model
// offers direct access (DMI), that takes none.
//
// A burst's ID says who makes it: bits 2:0 and 11 the port of the interconnect, 010 and 0 the
// processors, 001 and 0 the DMA controller; bits 10:3 what that gives.  Of the processors that is
// the L2 cache's: a linefill buffer of four for reads, a slot of three of the store buffer for
// writes to Device and Normal memory, 0 for Strongly-ordered ones; here each in turn.  Of the DMA
// controller it is the channel.
//
// The processor's writes to Device and Normal memory are posted, where the model takes that: the
// transaction is OK at once, and up to three such bursts, as many as the L2 cache's store buffer
// has slots, are under way together.  The next one waits for a slot; every other access waits for
// all of them, which keeps the program's order.  While any is under way the FPGA is looked at more
// often, so that interrupts that they change come soon.
//
// An error that the FPGA answers by BRESP or RRESP is TLM_GENERIC_ERROR, and ends the transaction.
// Where it does not answer within 20 ms of simulated time the transaction is TLM_INCOMPLETE: the
// board's processor would hang for ever.  Of a posted write it is notified: on_posted_failure().
//
// Sources: Intel, "How do I decode the AXI ID fields from the HPS-FPGA bridges"; Cyclone V HPS TRM,
// "HPS Peripheral Master Input IDs"; Cortex-A9 MPCore TRM (ARM DDI 0407I), 2.3.3; of the L2
// cache, the same in both chips, AMD UG585 (Zynq-7000), "Store Buffer Operation".
//
// LDREX and STREX have AxLOCK 1.  The answer to STREX decides whether it succeeds: EXOKAY, or OKAY
// of a slave that does not keep exclusive accesses apart, and then it fails each time.
//
// Not handled: the processor's own store buffer before the L2 cache's, which holds some stores
// more; loads from Normal memory that overlap, with others or with stores.  Writes of kernel
// modules under the emulated Linux, and all on this project's own computer, are not posted.  That
// the store buffer's slots write with the IDs that the TRM gives them for reads is not documented.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "sim/chip/axi_bursts.h"
#include "sim/chip/fpga_chip.h"
#include "sim/hps/axi_attributes.h"

#include <systemc>
#include <tlm>
#include <tlm_utils/simple_target_socket.h>

namespace sim {

class FpgaBridges : public sc_core::sc_module {
public:
    tlm_utils::simple_target_socket<FpgaBridges> lw, h2f;

    // How a transaction becomes bursts: as the processor or its DMA controller makes them
    // (axi_bursts.h), or each as long as AXI3 lets it be.
    enum class Bursts { OF_THE_PROCESSOR, LONG };

    FpgaBridges(const sc_core::sc_module_name& name, FpgaChip& fpga,
                Bursts bursts = Bursts::OF_THE_PROCESSOR);

    // Lets the access under way end, as SystemC's time goes on, and begins no other: the next
    // initiator waits for ever.
    void close() { closed_ = true; }
    bool is_busy() const { return busy_; }
    // Direct access to a copy of a part of the window at `window`; and what was written by one.
    struct Copy {
        std::function<bool(std::uint32_t window, const tlm::tlm_generic_payload& tx,
                           tlm::tlm_dmi& dmi)>
            direct;
        std::function<void(std::uint32_t address, const std::uint8_t* data, unsigned bytes)>
            written;
    };
    void set_copy(Copy copy);
    // Of a posted write: its answer is an error (BridgeBurst::SLVERR or DECERR), or it has none 20
    // ms after the last one was posted; then `error` is OKAY.
    using PostedFailure = std::function<void(const std::string& what, unsigned error)>;
    void on_posted_failure(PostedFailure notify) { posted_failure_ = std::move(notify); }
    // Of the last access that failed: "its bridge waits for rvalid", "RRESP SLVERR"; empty: not
    // known.
    const std::string& why() const { return why_; }

    // Bytes of a bridge's window, read outside simulated time once the run is over: one burst, no
    // other transaction under way.  False: nobody answers.
    bool peek(bool full, std::uint32_t address, std::uint8_t* bytes, unsigned count);
    // The same for a register on the lightweight bridge.
    std::optional<std::uint32_t> peek(std::uint32_t address);

    // Makes the last access to a register on the lightweight bridge once more, in no work, where
    // the model is calm: the same time passes as by a transaction.  Returns when it ends, in ps of
    // SystemC's time; nothing if it may answer otherwise.
    std::optional<std::uint64_t> again(bool write, std::uint64_t begin_ps);

private:
    void lightweight_transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay);
    void full_transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay);
    void transport(bool full, tlm::tlm_generic_payload& tx, sc_core::sc_time& delay);
    bool direct_in_lightweight(tlm::tlm_generic_payload& tx, tlm::tlm_dmi& dmi);
    bool direct_in_full(tlm::tlm_generic_payload& tx, tlm::tlm_dmi& dmi);
    bool direct_memory(bool full, tlm::tlm_generic_payload& tx, tlm::tlm_dmi& dmi);
    struct Transfer {
        bool full, write;
        unsigned width;  // of the bus, in bytes
        std::uint8_t* data;
    };
    tlm::tlm_response_status carry(const AxiBurst& part, const Transfer& transfer,
                                   AxiAttributes& how, sc_core::sc_time& delay);
    bool is_posted(bool write, const AxiAttributes& how) const;
    unsigned id_of(bool write, const AxiAttributes& how);
    unsigned id_of_slot();
    tlm::tlm_response_status play(const BridgeBurst& burst, sc_core::sc_time& delay);
    tlm::tlm_response_status post(BridgeBurst burst, sc_core::sc_time& delay);
    tlm::tlm_response_status leave_posted(unsigned most, sc_core::sc_time& delay);
    template <class Run>
    bool answers(Run run);
    void look_at_posted();
    void notify_of_refused();
    std::uint64_t start_of(const sc_core::sc_time& time) const;

    FpgaChip& fpga_;
    const Bursts bursts_;
    bool busy_ = false, closed_ = false;
    unsigned reads_ = 0, writes_ = 0;  // of the processor's, by which IDs come in turn
    std::string why_;
    Copy copy_;                        // or none
    std::uint64_t busy_until_ps_ = 0;  // by accesses that were made again
    // Until then no register changes, provided that FpgaChip::batches() is still calm_batches_.
    std::uint64_t calm_until_ps_ = 0, calm_batches_ = 0;
    std::uint64_t took_ps_[2] = {0, 0};  // the last read of a register, the last write
    sc_core::sc_event never_, free_, look_at_posted_;
    PostedFailure posted_failure_ = [](const std::string&, unsigned) {};
    sc_core::sc_time posted_at_, look_again_;  // the last write; after so long
};

}  // namespace sim
