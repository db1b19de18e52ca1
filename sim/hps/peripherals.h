// peripherals.h - the silicon around the processor, each block at its address and on its interrupt.
//
//   SCU, GIC, timers    0xFFFEC000 -     private to the processor
//   L2 cache            0xFFFEF000
//   on-chip RAM         0xFFFF0000       64 KB
//   UART0               0xFFC02000       ID 194
//   GPIO0, 1, 2         0xFF708000 0xFF709000 0xFF70A000                 IDs 196 - 198
//   I2C0 - 3            0xFFC04000 0xFFC05000 0xFFC06000 0xFFC07000      IDs 190 - 193
//   timers              0xFFC08000 0xFFC09000 0xFFD00000 0xFFD01000      IDs 199 - 202
//   watchdogs           0xFFD02000 0xFFD03000                            IDs 203, 204
//   managers            0xFF706000 FPGA, 0xFFD04000 clocks, 0xFFD05000 reset, 0xFFD08000 system;
//                       0xFF800000 L3
//
// Cyclone V HPS memory map.  The HPS's other blocks do not answer: absent_blocks.h.
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>

#include "sim/hps/bus.h"
#include "sim/hps/gic.h"
#include "sim/hps/global_timer.h"
#include "sim/hps/hps_gpio.h"
#include "sim/hps/hps_timer.h"
#include "sim/hps/i2c_controller.h"
#include "sim/hps/l4_watchdog.h"
#include "sim/hps/memory.h"
#include "sim/hps/private_timer.h"
#include "sim/hps/register_table.h"
#include "sim/hps/remembering_registers.h"
#include "sim/hps/reset_manager.h"
#include "sim/hps/uart.h"

namespace sim {

class Peripherals : public sc_core::sc_module {
public:
    // The wires that leave the peripherals.
    struct Wires {
        std::function<void(char)> console;
        std::function<void(bool irq, bool fiq)> interrupt;     // to the processor
        std::function<void()> warm_reset;                      // to the processor
        std::function<void(std::uint32_t brgmodrst)> bridges;  // ResetManager's bits
        // What the program should know: it asked for something that the simulation does not do.
        std::function<void(const std::string& line)> say = [](const std::string&) {};
    };

    static constexpr std::uint32_t GPIO1_BASE = 0xFF709000;

    Peripherals(const sc_core::sc_module_name& name, Wires wires);

    // Gives each block its window.
    void bind(Bus& bus);

    // The FPGA's interrupts: bit n is ID 72 + n.
    void fpga_interrupts(std::uint32_t levels);

    Gic gic;
    GlobalTimer global_timer;
    PrivateTimer private_timer;
    HpsTimer timer0, timer1, timer2, timer3;
    L4Watchdog watchdog0, watchdog1;
    Uart uart0;
    I2cController i2c0, i2c1, i2c2, i2c3;
    HpsGpio gpio0, gpio1, gpio2;
    ResetManager reset_manager;
    RememberingRegisters scu, l2_cache, system_manager, fpga_manager, l3;
    RegisterTable clock_manager;
    Memory on_chip_ram;

private:
    std::function<void(bool)> line(unsigned id);
    void reset_blocks(std::uint32_t permodrst);
    void say_once(const std::string& line);

    std::function<void()> warm_reset_;
    std::function<void(const std::string&)> say_;
    std::set<std::string> said_;
    std::uint32_t fpga_levels_ = 0;
};

}  // namespace sim
