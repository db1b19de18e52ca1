// project_bridges.h - the processor's bridges into a project's design, behind TLM
//
// A transaction becomes bursts (axi_bursts.h), one after the other, each as long as the design
// takes for it.  The design runs up to the burst's time before, and in batches between; an
// interrupt is notified when the design has run past it.
//
// A burst's ID says who makes it: bits 2:0 and 11 the port of the interconnect, 010 and 0 the
// processors, 001 and 0 the DMA controller; bits 10:3 what that gives.  Of the processors that is
// the L2 cache's: a linefill buffer of four for reads, a slot of three of the store buffer for
// writes to Device and Normal memory, 0 for Strongly-ordered ones; here each in turn.  Of the DMA
// controller it is the channel.
//
// An error that the design answers by BRESP or RRESP is TLM_GENERIC_ERROR, and ends the
// transaction.  Where it does not answer within 20 ms of simulated time the transaction is
// TLM_INCOMPLETE: the board's processor would hang for ever.
//
// Sources: Intel, "How do I decode the AXI ID fields from the HPS-FPGA bridges"; Cyclone V HPS TRM,
// "HPS Peripheral Master Input IDs"; Cortex-A9 MPCore TRM (ARM DDI 0407I), 2.3.3.
//
// LDREX and STREX have AxLOCK 1.  The answer to STREX decides whether it succeeds: EXOKAY, or OKAY
// of a slave that does not keep exclusive accesses apart, and then it fails each time.
//
// Not handled: posted writes, and bursts that overlap: the processor waits for each answer.  The
// board's does so, too, for Strongly-ordered memory, which is all that a program without
// translation tables reaches, and one of Linux by /dev/mem.  After a store to Device or Normal
// memory it goes on.  For that the processor would have to run ahead of an answer whose time and
// error only the design's clocks tell, and be taken back where the order is another.  That the
// store buffer's slots write with the IDs that the TRM gives them for reads is not documented.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "sim/chip/project_chip.h"
#include "sim/hps/axi_attributes.h"

#include <systemc>
#include <tlm>
#include <tlm_utils/simple_target_socket.h>

namespace sim {

class ProjectBridges : public sc_core::sc_module {
public:
    tlm_utils::simple_target_socket<ProjectBridges> lw, h2f;

    ProjectBridges(const sc_core::sc_module_name& name, ProjectChip& fpga);

    // Lets the access under way end, and begins no other: the next initiator waits for ever.
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
    // Of the last access that failed: "its bridge waits for rvalid", "RRESP SLVERR"; empty: not
    // known.
    const std::string& why() const { return why_; }

private:
    void lightweight_transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay);
    void full_transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay);
    void transport(bool full, tlm::tlm_generic_payload& tx, sc_core::sc_time& delay);
    bool direct_in_lightweight(tlm::tlm_generic_payload& tx, tlm::tlm_dmi& dmi);
    bool direct_in_full(tlm::tlm_generic_payload& tx, tlm::tlm_dmi& dmi);
    unsigned id_of(bool write, const AxiAttributes& how);
    tlm::tlm_response_status play(const project::BridgeBurst& burst, sc_core::sc_time& delay);

    ProjectChip& fpga_;
    bool busy_ = false, closed_ = false;
    unsigned reads_ = 0, writes_ = 0;  // of the processor's, by which IDs come in turn
    std::string why_;
    Copy copy_;  // or none
    sc_core::sc_event never_, free_;
};

}  // namespace sim
