// computer.h - the chip as this project fills it: the fabric of rtl/, and the processor with its
// silicon.
//
//   ProcessorSystem --+- Fpga lw, h2f --> pins
//                          +- JtagHost (JTAG UARTs)
#pragma once

#include <string>
#include <vector>

#include "sim/chip/jtag_host.h"
#include "sim/chip/lost_accesses.h"
#include "sim/chip/processor_system.h"
#include "sim/cpu/steady_bus.h"
#include "sim/fpga/fpga.h"
#include "sim/pins/chip.h"

namespace sim {

// The memory that programs are loaded into.
const std::vector<MemoryRange>& program_memory();

// Whether writing `value` there again and again is no more than writing it once: the parallel ports
// and GPIO1 of the HPS, but not the captured edges, where a 1 clears what came since.
bool is_plain_output(std::uint32_t address, std::uint32_t value);
// Whether reading `value` there removes nothing, and clears nothing; in the HPS also, whether it
// changes at events of SystemC alone.
bool is_plain_input(std::uint32_t address, std::uint32_t value);

class Computer : public ProcessorSystem, public Chip, private SteadyBus {
public:
    struct Settings {
        std::uint64_t seed = 1;  // of the phases between the processor's clock and the fabric's
        Trace trace;
        Fpga::Memory memory = Fpga::Memory::BRIDGED;
        unsigned audio_rate = 8'000;  // samples per second: or 48,000
        bool shortcuts = true;        // ArmCpu::leave_no_rounds_out()
    };

    Computer(const sc_core::sc_module_name& name, PinListener& pins, ChipObserver& observer,
             std::uint8_t* sdram, Software software, const Settings& settings);

    ChipInputs& inputs() override { return fpga.inputs(); }
    void catch_up() override { fpga.catch_up(); }
    std::uint64_t time_ps() const override {
        const bool by_program = arm && arm->is_running() && !fpga.is_busy();
        return by_program ? arm->now().value() : fpga.fabric().time_ps();
    }
    void hps_key(bool pressed) override { hps.gpio1.press_key(pressed); }
    void hps_accelerometer_interrupt(bool up) override { accelerometer_interrupt(up); }
    void type(const std::string& text, SerialLine to) override;
    std::optional<PixelBuffer> pixel_buffer() const override;
    void end_trace() override { fpga.end_trace(); }

    // The fabric has to have run for some microseconds since.
    bool is_printing() override { return jtag_host.rests() || ProcessorSystem::is_printing(); }
    void close_bridges() override { fpga.close(); }
    bool is_accessing() const override { return fpga.is_busy(); }

    // The character buffer's 60 rows of 80, as the processor would read it; once the run is over,
    // outside simulated time.  The monitor shows letters, but only as pixels.
    std::vector<std::string> characters();

private:
    std::uint64_t changes() const override { return fpga.changes(); }
    bool is_plain(std::uint32_t address, bool write, std::uint32_t value) const override {
        return !bus.is_watched() &&
               (write ? is_plain_output(address, value) : is_plain_input(address, value));
    }
    std::optional<RunningCount> running(std::uint32_t address,
                                        std::uint64_t time_ps) const override {
        return bus.is_watched() ? std::nullopt : hps.running(address, time_ps);
    }
    std::uint64_t fixed_ps(std::uint32_t address) const override;
    std::optional<std::uint64_t> again(bool write, std::uint64_t begin_ps) override {
        return fpga.again(write, begin_ps);
    }
    void left_out(bool write, std::uint64_t accesses) override { bus.left_out(write, accesses); }

    LostAccesses lost_accesses_;

public:
    Fpga fpga;
    JtagHost jtag_host;
};

}  // namespace sim
