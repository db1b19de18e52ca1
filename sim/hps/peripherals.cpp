#include "sim/hps/peripherals.h"

#include "sim/hps/absent_blocks.h"

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
    const auto add = [&bus](auto& target, const char* title, std::uint32_t base,
                            std::uint32_t size) {
        bus.window(title, base, size).bind(target.socket);
    };
    add(fpga_manager, "the FPGA manager", 0xFF706000, 0x1000);
    add(gpio1, "GPIO1 of the HPS", GPIO1_BASE, 0x1000);
    add(l3, "the L3 interconnect", 0xFF800000, 0x80000);
    add(uart0, "UART0", 0xFFC02000, 0x1000);
    add(timer0, "HPS timer 0", 0xFFC08000, 0x1000);
    add(timer1, "HPS timer 1", 0xFFC09000, 0x1000);
    add(timer2, "HPS timer 2", 0xFFD00000, 0x1000);
    add(timer3, "HPS timer 3", 0xFFD01000, 0x1000);
    add(reset_manager, "the reset manager", 0xFFD05000, 0x1000);
    add(system_manager, "the system manager", 0xFFD08000, 0x4000);
    add(scu, "the A9's SCU", 0xFFFEC000, 0x100);
    add(gic.cpu_interface, "the GIC's CPU interface", 0xFFFEC100, 0x100);
    add(global_timer, "the A9's global timer", 0xFFFEC200, 0x100);
    add(private_timer, "the A9's private timer", 0xFFFEC600, 0x100);
    add(gic.distributor, "the GIC's distributor", 0xFFFED000, 0x1000);
    add(l2_cache, "the L2 cache controller", 0xFFFEF000, 0x1000);
    add(on_chip_ram, "the HPS's on-chip RAM", 0xFFFF0000, 0x10000);
    bus.leave_out(absent_blocks());
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
