// native_cpu.h - the firmware compiled for the host, as a TLM initiator.
//
// The firmware runs in an SC_THREAD.  Its instructions take no time; bus accesses take what the
// target says, idle() takes 50 us.  It runs ahead of SystemC until the next thing that SystemC has
// to do, so no pin that the board moves is ever late for it.
//
// An access that is not answered OK ends the firmware, as a data abort would: see fault().
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "hal/cpu.h"
#include "hal/mmio.h"

#include <systemc>
#include <tlm>
#include <tlm_utils/simple_initiator_socket.h>

namespace sim {

// What a program for this processor is: runs for ever or returns when it is done.
using Firmware = std::function<void(hal::Mmio&, hal::Cpu&)>;

class NativeCpu : public sc_core::sc_module, private hal::Mmio, private hal::Cpu {
public:
    tlm_utils::simple_initiator_socket<NativeCpu> socket;

    NativeCpu(const sc_core::sc_module_name& name, Firmware firmware);

    // Why the firmware was ended: "data abort: read of 4 bytes at 0xFF200FF0 at 12.345 ms (...)".
    const std::optional<std::string>& fault() const { return fault_; }
    // Notified with the fault.
    const sc_core::sc_event& faulted() const { return faulted_; }

private:
    struct Abort {};

    std::uint32_t read(std::uint32_t address) override;
    void write(std::uint32_t address, std::uint32_t value) override;
    void write_words(std::uint32_t address, const std::uint32_t* words, unsigned count) override;
    void idle() override;

    void run();
    void access(tlm::tlm_command command, std::uint32_t address, void* data, unsigned bytes);

    Firmware firmware_;
    sc_core::sc_time ahead_;  // of SystemC's time
    std::optional<std::string> fault_;
    sc_core::sc_event faulted_;
};

}  // namespace sim
