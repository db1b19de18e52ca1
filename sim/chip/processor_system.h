// processor_system.h - the processor with its silicon and its memory (HPS), without the FPGA
//
//   Processor -- Bus -+- DDR3
//                     +- Peripherals (GIC, timers, UART0, GPIO1, managers, on-chip RAM)
//                     +- lightweight and full bridge: windows that somebody else serves
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <variant>

#include "sim/chip/program_system.h"
#include "sim/cpu/arm_cpu.h"
#include "sim/cpu/native_cpu.h"
#include "sim/hps/bridge_windows.h"
#include "sim/hps/bus.h"
#include "sim/hps/memory.h"
#include "sim/hps/peripherals.h"
#include "sim/hps/pixel_buffer.h"
#include "sim/pins/chip.h"

#include <systemc>

namespace sim {

class ProcessorSystem : public sc_core::sc_module, public ProgramSystem {
public:
    // What runs on it, and so which processor it has: NativeCpu or ArmCpu.
    using Software = std::variant<Firmware, ArmProgram>;

    static constexpr std::uint32_t DDR3_BASE = 0, DDR3_SIZE = 0x40000000;

    ProcessorSystem(const sc_core::sc_module_name& name, PinListener& pins, ChipObserver& observer,
                    Software software);

    // What /dev/fb0 is; nothing: the FPGA has none that could be found.
    virtual std::optional<PixelBuffer> pixel_buffer() const { return {}; }
    Processor& processor() override { return cpu; }
    ProgramCpu* program_cpu() override { return arm; }
    Bus& processor_bus() override { return bus; }
    bool is_printing() override { return hps.uart0.is_sending(); }
    bool is_sending() const override { return hps.uart0.is_sending(); }

    // An interrupt line of the HPS's own pins: GPIO61, the accelerometer's INT1.
    void accelerometer_interrupt(bool up) { hps.gpio2.drive(ACCELEROMETER, up); }

private:
    // h2f_reset, at a reset of the processor.
    virtual void reset_fpga(bool /*cold*/) {}
    // The general purpose signals, to the design and from it.
    virtual void general_purpose(std::uint32_t /*gpo*/, const sc_core::sc_time& /*now*/) {}
    virtual std::uint32_t general_purpose(const sc_core::sc_time& /*now*/) { return 0; }

    static constexpr unsigned ACCELEROMETER = 61 - 58;  // GPIO61 is GPIO2's pin 3

    std::function<void(bool)> h2f_gate_, lw_gate_;  // true: out of reset

public:
    Memory ddr3;
    Peripherals hps;
    Bus bus;

private:
    std::unique_ptr<Processor> processor_;

public:
    Processor& cpu;
    ArmCpu* const arm;  // the same, if that is what it is

protected:
    // The windows "lw" and "h2f", to be bound.
    tlm_utils::simple_initiator_socket<Bus>&lightweight_window, &full_window;
};

}  // namespace sim
