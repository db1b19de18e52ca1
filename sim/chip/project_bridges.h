// project_bridges.h - the processor's bridges into a project's design, behind TLM
//
// A transaction becomes accesses of up to eight bytes, or of the bridge's width, each as long as
// the design takes for it.  The design runs up to the access's time before, and in batches between;
// an interrupt is notified when the design has run past it.
//
// Where the design does not answer within 20 ms of simulated time the transaction is
// TLM_INCOMPLETE: the board's processor would hang for ever.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "sim/chip/project_chip.h"

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
    // The signal that an access has waited for, if one was not answered and it is known.
    const std::string& missing() const { return missing_; }

private:
    void lightweight_transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay);
    void full_transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay);
    void transport(bool full, tlm::tlm_generic_payload& tx, sc_core::sc_time& delay);
    bool access(const project::BridgeAccess& access, sc_core::sc_time& delay);

    ProjectChip& fpga_;
    bool busy_ = false, closed_ = false;
    std::string missing_;
    sc_core::sc_event never_;
};

}  // namespace sim
