#include "sim/chip/processor_system.h"

#include <utility>

namespace sim {

namespace {

std::unique_ptr<Processor> processor_for(ProcessorSystem::Software software,
                                         ChipObserver& observer) {
    if (auto* firmware = std::get_if<Firmware>(&software))
        return std::make_unique<NativeCpu>("cpu", std::move(*firmware));
    return std::make_unique<ArmCpu>("cpu", std::get<ArmProgram>(std::move(software)),
                                    [&observer](const std::string& line) { observer.log(line); });
}

}  // namespace

ProcessorSystem::ProcessorSystem(const sc_core::sc_module_name& name, PinListener& pins,
                                 ChipObserver& observer, Software software)
    : sc_module{name},
      ddr3{"ddr3", DDR3_SIZE, sc_core::sc_time{60, sc_core::SC_NS}},
      hps{"hps",
          {[&observer](char character) { observer.console(character, SerialLine::UART); },
           [this](bool irq, bool fiq) { cpu.interrupt(irq, fiq); },
           [this](bool cold) {
               cpu.warm_reset();
               reset_fpga(cold);
           },
           [this](std::uint32_t in_reset) {
               h2f_gate_(!(in_reset & ResetManager::H2F));
               lw_gate_(!(in_reset & ResetManager::LWH2F));
           },
           [this](auto&&... burst) { return bus.transfer(burst...); },
           [this](std::uint32_t gpo, const sc_core::sc_time& now) { general_purpose(gpo, now); },
           [this](const sc_core::sc_time& now) { return general_purpose(now); },
           [this, &observer](const std::string& line) { observer.log(line + cpu.accessed()); }}},
      bus{"bus"},
      processor_{processor_for(std::move(software), observer)},
      cpu{*processor_},
      arm{dynamic_cast<ArmCpu*>(processor_.get())},
      lightweight_window{bus.window("lw", LW_BASE, LW_SIZE)},
      full_window{bus.window("h2f", H2F_BASE, H2F_SIZE)} {
    cpu.socket.bind(bus.socket);
    bus.window("ddr3", DDR3_BASE, DDR3_SIZE).bind(ddr3.socket);
    hps.bind(bus);
    h2f_gate_ = bus.gate("h2f");
    lw_gate_ = bus.gate("lw");
    bus.describe("ddr3", "the DDR3", {{"the DDR3", DDR3_BASE, DDR3_SIZE, true}});
    cpu.explain_by([this](auto... access) { return bus.refusal(access...); });
    hps.gpio1.on_led(
        [&pins](bool lit, const sc_core::sc_time& now) { pins.hps_led(lit, now.value()); });
    hps.gpio1.on_pins(
        [&pins](std::uint32_t levels, const sc_core::sc_time&) { pins.hps_gpio1(levels); });
    hps.spi_master0.on_frame([&pins](unsigned slaves, std::uint32_t frame) {
        if (slaves & 1) pins.hps_spi0(frame);
    });
    hps.i2c0.connect(pins.hps_i2c0());
    hps.gpio2.drive(ACCELEROMETER, false);
}

}  // namespace sim
