// native_cpu.h - the firmware compiled for the host, as a TLM initiator.
//
// The firmware runs in an SC_THREAD.  Its instructions take no time; bus accesses take what the
// target says, idle() takes 50 us.  It runs ahead of SystemC until SystemC's next event, so never
// past a change of a pin by the board.
//
// An access that is not answered OK ends the firmware, as a data abort would: see fault().
//
// Not handled: interrupts; firmware for this processor polls.
#pragma once

#include "sim/cpu/firmware.h"
#include "sim/cpu/processor.h"

namespace sim {

class NativeCpu : public Processor, private hal::Mmio, private hal::Cpu {
public:
    NativeCpu(const sc_core::sc_module_name& name, Firmware firmware);

private:
    struct Abort {};

    std::uint32_t read(std::uint32_t address) override;
    void write(std::uint32_t address, std::uint32_t value) override;
    void write_words(std::uint32_t address, const std::uint32_t* words, unsigned count) override;
    void idle() override;
    std::uint32_t micros() override;
    void print(const char* text) override;

    void run();
    void access(tlm::tlm_command command, std::uint32_t address, void* data, unsigned bytes);

    Firmware firmware_;
    sc_core::sc_time ahead_;  // of SystemC's time
};

}  // namespace sim
