// memory.h - DDR3 and on-chip RAM: bytes that remember, allocated when first written.
//
// Reads as 0 where nothing was written.  An access takes `latency`, whatever its length.
//
// Not handled: refresh, banks, and the caches in front of it; byte enables (TLM_BYTE_ENABLE_ERROR).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <unordered_map>

#include <systemc>
#include <tlm>
#include <tlm_utils/simple_target_socket.h>

namespace sim {

class Memory : public sc_core::sc_module {
public:
    tlm_utils::simple_target_socket<Memory> socket;

    Memory(const sc_core::sc_module_name& name, std::uint32_t size, sc_core::sc_time latency);

private:
    static constexpr std::uint32_t PAGE = 64 * 1024;
    using Page = std::array<std::uint8_t, PAGE>;

    void b_transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay);

    const std::uint32_t size_;
    const sc_core::sc_time latency_;
    std::unordered_map<std::uint32_t, std::unique_ptr<Page>> pages_;
};

}  // namespace sim
