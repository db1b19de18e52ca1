#include "sim/hps/peripherals.h"

namespace sim {

namespace {

constexpr std::uint64_t SP_TIMER_HZ = 100'000'000, OSC_TIMER_HZ = 25'000'000;
constexpr unsigned GLOBAL_TIMER_ID = 27, PRIVATE_TIMER_ID = 29, WATCHDOG_ID = 30, FPGA_ID = 72,
                   UART0_ID = 194, GPIO1_ID = 197, TIMER0_ID = 199;

}  // namespace

std::function<void(bool)> Peripherals::line(unsigned id) {
    return [this, id](bool up) { gic.set_level(id, up); };
}

Peripherals::Peripherals(const sc_core::sc_module_name& name, Wires wires)
    : sc_module{name},
      gic{"gic", std::move(wires.interrupt)},
      global_timer{"global_timer", line(GLOBAL_TIMER_ID)},
      private_timer{"private_timer", line(PRIVATE_TIMER_ID), line(WATCHDOG_ID), wires.warm_reset},
      timer0{"timer0", SP_TIMER_HZ, line(TIMER0_ID)},
      timer1{"timer1", SP_TIMER_HZ, line(TIMER0_ID + 1)},
      timer2{"timer2", OSC_TIMER_HZ, line(TIMER0_ID + 2)},
      timer3{"timer3", OSC_TIMER_HZ, line(TIMER0_ID + 3)},
      uart0{"uart0", std::move(wires.console), line(UART0_ID)},
      gpio1{"gpio1", line(GPIO1_ID)},
      reset_manager{"reset_manager", std::move(wires.bridges), wires.warm_reset},
      scu{"scu", remembering::scu()},
      l2_cache{"l2_cache", remembering::l2_cache()},
      system_manager{"system_manager", remembering::system_manager()},
      fpga_manager{"fpga_manager", remembering::fpga_manager()},
      l3{"l3", {}},
      on_chip_ram{"on_chip_ram", 0x10000, sc_core::sc_time{10, sc_core::SC_NS}} {}

void Peripherals::bind(Bus& bus) {
    bus.window("fpga_manager", 0xFF706000, 0x1000).bind(fpga_manager.socket);
    bus.window("gpio1", 0xFF709000, 0x1000).bind(gpio1.socket);
    bus.window("l3", 0xFF800000, 0x80000).bind(l3.socket);
    bus.window("uart0", 0xFFC02000, 0x1000).bind(uart0.socket);
    bus.window("timer0", 0xFFC08000, 0x1000).bind(timer0.socket);
    bus.window("timer1", 0xFFC09000, 0x1000).bind(timer1.socket);
    bus.window("timer2", 0xFFD00000, 0x1000).bind(timer2.socket);
    bus.window("timer3", 0xFFD01000, 0x1000).bind(timer3.socket);
    bus.window("reset_manager", 0xFFD05000, 0x1000).bind(reset_manager.socket);
    bus.window("system_manager", 0xFFD08000, 0x4000).bind(system_manager.socket);
    bus.window("scu", 0xFFFEC000, 0x100).bind(scu.socket);
    bus.window("gic_cpu", 0xFFFEC100, 0x100).bind(gic.cpu_interface.socket);
    bus.window("global_timer", 0xFFFEC200, 0x100).bind(global_timer.socket);
    bus.window("private_timer", 0xFFFEC600, 0x100).bind(private_timer.socket);
    bus.window("gic_distributor", 0xFFFED000, 0x1000).bind(gic.distributor.socket);
    bus.window("l2_cache", 0xFFFEF000, 0x1000).bind(l2_cache.socket);
    bus.window("on_chip_ram", 0xFFFF0000, 0x10000).bind(on_chip_ram.socket);
}

void Peripherals::fpga_interrupts(std::uint32_t levels) {
    const std::uint32_t moved = levels ^ fpga_levels_;
    fpga_levels_ = levels;
    for (unsigned bit = 0; moved >> bit; ++bit) {
        if (moved >> bit & 1) gic.set_level(FPGA_ID + bit, levels >> bit & 1);
        if (bit == 31) break;
    }
}

}  // namespace sim
