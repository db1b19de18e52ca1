// computer_fabric.h - the FPGA of the DE1-SoC Computer, whichever processor it has: the fabric of
// rtl/, and a PC at its JTAG UARTs
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/chip/fpga_bridges.h"
#include "sim/chip/fpga_chip.h"
#include "sim/chip/jtag_host.h"
#include "sim/chip/lost_accesses.h"
#include "sim/cpu/processor.h"
#include "sim/fpga/fabric.h"
#include "sim/hps/bus.h"
#include "sim/pins/chip.h"

namespace sim {

// Whether writing `value` there again and again is no more than writing it once: the parallel ports
// and GPIO1 of the HPS, but not the captured edges, where a 1 clears what came since.
bool is_plain_output(std::uint32_t address, std::uint32_t value);
// Whether reading `value` there removes nothing, and clears nothing; in the HPS also, whether it
// changes at events of SystemC alone.
bool is_plain_input(std::uint32_t address, std::uint32_t value);

class ComputerFabric : public Chip {
public:
    struct Settings {
        std::uint64_t seed = 1;  // of the phases between the processor's clock and the fabric's
        Trace trace;
        Fabric::Memory memory = Fabric::Memory::BRIDGED;
        unsigned audio_rate = 8'000;  // samples per second: or 48,000
        bool shortcuts = true;        // ArmCpu::leave_no_rounds_out()
        bool has_jp2 = true;          // the parallel port JP2, which the DE10-Standard's has not
    };

    // `memory_base`: where the processor sees the SDRAM, and the other memories behind it.
    ComputerFabric(PinListener& pins, ChipObserver& observer, std::uint8_t* sdram,
                   const Settings& settings, std::uint32_t memory_base);

    ChipInputs& inputs() override { return fabric.in; }
    void catch_up() override { fpga.catch_up(); }
    void end_trace() override { fabric.end_trace(); }

    // The program has written into the fabric's memories.
    virtual bool has_written_memory() const = 0;
    // Beside the fabric's memories the processor has one of its own, which the fabric cannot show.
    virtual bool has_own_memory() const = 0;

    // The character buffer's 60 rows of 80, as the processor would read it; once the run is over,
    // outside simulated time.  The monitor shows letters, but only as pixels.
    std::vector<std::string> characters();

protected:
    // Names the places behind these windows of the bus, and reports accesses that go astray.
    // `others`: what answers among the registers besides the fabric.
    void describe(const char* memories, const char* registers, Bus& bus, const Processor& cpu,
                  ChipObserver& observer, const std::vector<Bus::Place>& others = {});

private:
    LostAccesses lost_accesses_;

public:
    Fabric fabric;
    FpgaChip fpga;
    FpgaBridges bridges;
    JtagHost jtag_host;

private:
    const std::uint32_t memory_base_;
    const bool has_jp2_;
};

}  // namespace sim
