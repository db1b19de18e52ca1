// nios_v_computer.h - the chip as the DE1-SoC Computer with Nios V: the processor in the FPGA, its
// memories and registers; no HPS
//
//   NiosVCpu -- Bus -+- FpgaBridges h2f: SDRAM 0, on-chip memory 0x08000000, characters 0x09000000
//                    +- NiosVWindow --> FpgaBridges lw, 0xFF200000; MachineTimer --> pins
//                       JtagHost
//
// The fabric is that of the ARM's computer; what differs is its place in the map and the number of
// each interrupt.
//
// Not handled: the second Nios V, the debug module at 0x0A000000.  An access to the fabric takes as
// long as through the ARM's bridges, which have a slower clock than Nios V's interconnect.  Where
// no memory is below 0x10000000 the SDRAM answers, as for the ARM: what Nios V's interconnect does
// there is a guess.  The second JTAG UART, which the ARM alone has, answers here, too.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/chip/computer_fabric.h"
#include "sim/chip/nios_v_devices.h"
#include "sim/chip/program_system.h"
#include "sim/cpu/nios_v_cpu.h"
#include "sim/cpu/steady_bus.h"

namespace sim {

// The memory that programs for it are loaded into.
const std::vector<MemoryRange>& nios_v_memory();

// The interrupt of Nios V that is this one of the fabric, by its ID at the ARM's interrupt
// controller; 0: none.
unsigned nios_v_interrupt(unsigned id);

class NiosVComputer : public sc_core::sc_module,
                      public ProgramSystem,
                      public ComputerFabric,
                      private SteadyBus {
public:
    NiosVComputer(const sc_core::sc_module_name& name, PinListener& pins, ChipObserver& observer,
                  std::uint8_t* sdram, NiosVProgram program, const Settings& settings);

    std::uint64_t time_ps() const override {
        const bool by_program = cpu.is_running() && !bridges.is_busy();
        return by_program ? cpu.now().value() : fabric.time_ps();
    }
    void type(const std::string& text, SerialLine to) override;

    Processor& processor() override { return cpu; }
    ProgramCpu* program_cpu() override { return &cpu; }
    Bus& processor_bus() override { return bus; }
    bool is_printing() override { return jtag_host.rests(); }
    void close_bridges() override { bridges.close(); }
    bool is_accessing() const override { return bridges.is_busy(); }

    bool has_written_memory() const override { return bus.written("memory"); }
    bool has_own_memory() const override { return false; }

protected:
    // Without the windows of the bus: a derived class has a map of its own.
    struct NoMap {};
    NiosVComputer(const sc_core::sc_module_name& name, PinListener& pins, ChipObserver& observer,
                  std::uint8_t* sdram, NiosVProgram program, const Settings& settings, NoMap);

    bool is_plain(std::uint32_t address, bool write, std::uint32_t value) const override;
    // The level of an interrupt that is none of the fabric's, a bit of mip.
    void set_line(unsigned number, bool up);

private:
    std::uint64_t changes() const override { return fabric.changes(); }
    std::uint64_t fixed_ps(std::uint32_t) const override { return 0; }
    std::optional<std::uint64_t> again(bool write, std::uint64_t begin_ps) override {
        return bridges.again(write, begin_ps);
    }
    void left_out(bool write, std::uint64_t accesses) override { bus.left_out(write, accesses); }
    void fabric_interrupts(std::uint64_t levels);

    void hand_on_lines() { cpu.set_lines(of_timer_ | of_fabric_ | of_others_); }

    std::uint32_t of_fabric_ = 0, of_timer_ = 0, of_others_ = 0;  // bits of mip

public:
    Bus bus;
    NiosVWindow window;
    MachineTimer timer;
    NiosVCpu cpu;
};

}  // namespace sim
