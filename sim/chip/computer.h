// computer.h - the chip as this project fills it: the fabric of rtl/, and the processor with its
// silicon.
//
//   ProcessorSystem --+- FpgaBridges --> FpgaChip with Fabric --> pins
//                          +- JtagHost (JTAG UARTs)
#pragma once

#include <string>
#include <vector>

#include "sim/chip/computer_fabric.h"
#include "sim/chip/processor_system.h"
#include "sim/cpu/steady_bus.h"

namespace sim {

// The memory that programs are loaded into.
const std::vector<MemoryRange>& program_memory();

class Computer : public ProcessorSystem, public ComputerFabric, private SteadyBus {
public:
    Computer(const sc_core::sc_module_name& name, PinListener& pins, ChipObserver& observer,
             std::uint8_t* sdram, Software software, const Settings& settings);

    std::uint64_t time_ps() const override {
        const bool by_program = arm && arm->is_running() && !bridges.is_busy();
        return by_program ? arm->now().value() : fabric.time_ps();
    }
    void hps_key(bool pressed) override { hps.gpio1.press_key(pressed); }
    void hps_accelerometer_interrupt(bool up) override { accelerometer_interrupt(up); }
    void type(const std::string& text, SerialLine to) override;
    std::optional<PixelBuffer> pixel_buffer() const override;

    // The fabric has to have run for some microseconds since.
    bool is_printing() override { return jtag_host.rests() || ProcessorSystem::is_printing(); }
    void close_bridges() override { bridges.close(); }
    bool is_accessing() const override { return bridges.is_busy(); }

    bool has_written_memory() const override { return bus.written("h2f"); }
    bool has_own_memory() const override { return true; }

private:
    std::uint64_t changes() const override { return fabric.changes(); }
    bool is_plain(std::uint32_t address, bool write, std::uint32_t value) const override {
        return !bus.is_watched() && !bus.is_diverted(address) &&
               (write ? is_plain_output(address, value) : is_plain_input(address, value));
    }
    std::optional<RunningCount> running(std::uint32_t address,
                                        std::uint64_t time_ps) const override {
        return bus.is_watched() ? std::nullopt : hps.running(address, time_ps);
    }
    std::uint64_t fixed_ps(std::uint32_t address) const override;
    std::optional<std::uint64_t> again(bool write, std::uint64_t begin_ps) override {
        return bridges.again(write, begin_ps);
    }
    void left_out(bool write, std::uint64_t accesses) override { bus.left_out(write, accesses); }
};

}  // namespace sim
