// peripherals.h - the silicon around the processor, each block at its address and on its interrupt.
//
//   SCU, GIC, timers    0xFFFEC000 -     private to the processor
//   L2 cache            0xFFFEF000
//   on-chip RAM         0xFFFF0000       64 KB
//   UART0, UART1        0xFFC02000 0xFFC03000                            IDs 194, 195
//   GPIO0, 1, 2         0xFF708000 0xFF709000 0xFF70A000                 IDs 196 - 198
//   I2C0 - 3            0xFFC04000 0xFFC05000 0xFFC06000 0xFFC07000      IDs 190 - 193
//   timers              0xFFC08000 0xFFC09000 0xFFD00000 0xFFD01000      IDs 199 - 202
//   SPI masters, slaves 0xFFF00000 0xFFF01000 0xFFE02000 0xFFE03000      IDs 186 - 189
//   DMA controller      0xFFE01000                                       IDs 136 - 144
//   watchdogs           0xFFD02000 0xFFD03000                            IDs 203, 204
//   managers            0xFF706000 FPGA, 0xFFD04000 clocks, 0xFFD05000 reset, 0xFFD08000 system;
//                       0xFF800000 L3, 0xFFC20000 the DDR3's controller, 0xFFF02000 scan
//
// Cyclone V HPS memory map.  The HPS's other blocks do not answer: absent_blocks.h.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>

#include "sim/hps/bus.h"
#include "sim/hps/dma330.h"
#include "sim/hps/fpga_manager.h"
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
#include "sim/hps/spi_controller.h"
#include "sim/hps/uart.h"

namespace sim {

class Peripherals : public sc_core::sc_module {
public:
    // The wires that leave the peripherals.
    struct Wires {
        std::function<void(char)> console;
        std::function<void(bool irq, bool fiq)> interrupt;     // to the processor
        std::function<void(bool cold)> reset;                  // to the processor and the FPGA
        std::function<void(std::uint32_t brgmodrst)> bridges;  // ResetManager's bits
        // The DMA controller's bursts: Bus::transfer().
        std::function<bool(bool write, std::uint32_t address, std::uint8_t* data, unsigned bytes,
                           AxiAttributes& how, sc_core::sc_time& delay)>
            transfer = [](bool, std::uint32_t, std::uint8_t*, unsigned, AxiAttributes&,
                          sc_core::sc_time&) { return false; };
        // The general purpose signals: to the FPGA, from it.
        std::function<void(std::uint32_t gpo, const sc_core::sc_time& now)> gpo =
            [](std::uint32_t, const sc_core::sc_time&) {};
        std::function<std::uint32_t(const sc_core::sc_time& now)> gpi =
            [](const sc_core::sc_time&) { return 0; };
        // What the program should know: it asked for something that the simulation does not do.
        std::function<void(const std::string& line)> log = [](const std::string&) {};
    };

    static constexpr std::uint32_t GPIO1_BASE = 0xFF709000;

    Peripherals(const sc_core::sc_module_name& name, Wires wires);

    // Gives each block its window.
    void bind(Bus& bus);

    // How the counter goes on that is read at this address; nothing if there is none.
    std::optional<RunningCount> running(std::uint32_t address, std::uint64_t now_ps) const;

    // The FPGA's interrupts: bit n is ID 72 + n.
    void fpga_interrupts(std::uint64_t levels);

    Gic gic;
    GlobalTimer global_timer;
    PrivateTimer private_timer;
    HpsTimer timer0, timer1, timer2, timer3;
    L4Watchdog watchdog0, watchdog1;
    Uart uart0, uart1;  // nothing is on UART1's line, unless the FPGA is
    I2cController i2c0, i2c1, i2c2, i2c3;
    HpsGpio gpio0, gpio1, gpio2;
    SpiController spi_master0, spi_master1, spi_slave0, spi_slave1;
    Dma330 dma;
    ResetManager reset_manager;
    FpgaManager fpga_manager;
    RememberingRegisters scu, l2_cache, system_manager, l3, sdram_control, scan_manager;
    RegisterTable clock_manager;
    Memory on_chip_ram;

private:
    std::function<void(bool)> line(unsigned id);
    void reset_blocks(std::uint32_t permodrst);
    void log_once(const std::string& line);

    std::function<void(bool cold)> reset_;
    std::function<void(const std::string&)> log_;
    std::set<std::string> logged_;
    std::uint64_t fpga_levels_ = 0;
};

}  // namespace sim
