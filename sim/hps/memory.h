// memory.h - DDR3 and on-chip RAM, allocated by the host when first touched.
//
// Reads as 0 where nothing was written.  An access by the bus takes `latency`, whatever its length.
// Grants direct access (DMI) to its whole range, that is to the same bytes.
//
// Not handled: refresh, banks, and the caches in front of it; byte enables (TLM_BYTE_ENABLE_ERROR).
#pragma once

#include <cstdint>

#include <systemc>
#include <tlm>
#include <tlm_utils/simple_target_socket.h>

namespace sim {

class Memory : public sc_core::sc_module {
public:
    tlm_utils::simple_target_socket<Memory> socket;

    // std::bad_alloc if the host lacks the address space.
    Memory(const sc_core::sc_module_name& name, std::uint32_t size, sc_core::sc_time latency);
    ~Memory() override;

    std::uint8_t* bytes() { return bytes_; }

private:
    void b_transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay);
    bool get_direct_mem_ptr(tlm::tlm_generic_payload& tx, tlm::tlm_dmi& dmi);

    const std::uint32_t size_;
    const sc_core::sc_time latency_;
    std::uint8_t* bytes_;
};

}  // namespace sim
