// bus.h - the processor's address map: decodes, forwards, counts, and answers every wrong access.
//
// Loosely timed: adds no delay of its own; the target's delay is the access's.
// An address that no window owns, or an access that leaves its window, is TLM_ADDRESS_ERROR; so is
// one to a window that is switched off, as a bridge in reset is.
//
// Direct access (DMI) is asked of the window's target.  Refused, the range that comes back is the
// one without direct access around the address: a window, or the gap between two.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <systemc>
#include <tlm>
#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>

namespace sim {

struct BusCounts {
    std::uint64_t reads = 0, writes = 0;  // transactions of up to a word
    std::uint64_t bursts = 0;             // longer ones
    std::uint64_t errors = 0;             // answered with anything but OK
};

class Bus : public sc_core::sc_module {
public:
    tlm_utils::simple_target_socket<Bus> socket;

    explicit Bus(const sc_core::sc_module_name& name);

    // Adds a window and returns the socket that serves it, with addresses from 0.  Two windows that
    // overlap are a fault in the assembly: SC_REPORT_FATAL.
    tlm_utils::simple_initiator_socket<Bus>& window(const std::string& name, std::uint32_t base,
                                                    std::uint32_t size);

    // Switches the window `name` on or off; all are on at first.
    void answer(const std::string& name, bool on);

    const BusCounts& counts() const { return counts_; }

private:
    struct Window {
        std::string name;
        std::uint32_t base, size;
        std::unique_ptr<tlm_utils::simple_initiator_socket<Bus>> socket;
        bool on = true;
    };

    void b_transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay);
    bool get_direct_mem_ptr(tlm::tlm_generic_payload& tx, tlm::tlm_dmi& dmi);
    Window* find(std::uint64_t address, unsigned bytes);

    std::vector<Window> windows_;
    BusCounts counts_;
};

}  // namespace sim
