#include "sim/hps/peripherals.h"

#include "sim/hps/absent_blocks.h"
#include "sim/hps/clock_manager.h"

namespace sim {

namespace {

constexpr std::uint64_t SP_TIMER_HZ = 100'000'000, OSC_TIMER_HZ = 25'000'000;
constexpr unsigned DMA_ID = 136, DMA_ABORT_ID = 144, SPI_ID = 186, GLOBAL_TIMER_ID = 27,
                   PRIVATE_TIMER_ID = 29, WATCHDOG_ID = 30, FPGA_ID = 72, I2C0_ID = 190,
                   UART0_ID = 194, GPIO0_ID = 196, TIMER0_ID = 199, L4_WATCHDOG0_ID = 203;

// permodrst
constexpr std::uint32_t WATCHDOG0 = 1 << 6, WATCHDOG1 = 1 << 7, I2C0 = 1 << 12,
                        SPI_MASTER0 = 1 << 18, DMA = 1 << 28;

}  // namespace

std::function<void(bool)> Peripherals::line(unsigned id) {
    return [this, id](bool up) { gic.set_level(id, up); };
}

Peripherals::Peripherals(const sc_core::sc_module_name& name, Wires wires)
    : sc_module{name},
      gic{"gic", std::move(wires.interrupt)},
      global_timer{"global_timer", line(GLOBAL_TIMER_ID)},
      private_timer{"private_timer", line(PRIVATE_TIMER_ID), line(WATCHDOG_ID),
                    [this] { reset_manager.reset(ResetManager::MPU_WATCHDOG); }},
      timer0{"timer0", SP_TIMER_HZ, line(TIMER0_ID)},
      timer1{"timer1", SP_TIMER_HZ, line(TIMER0_ID + 1)},
      timer2{"timer2", OSC_TIMER_HZ, line(TIMER0_ID + 2)},
      timer3{"timer3", OSC_TIMER_HZ, line(TIMER0_ID + 3)},
      watchdog0{"watchdog0", line(L4_WATCHDOG0_ID),
                [this] { reset_manager.reset(ResetManager::L4_WATCHDOG_0); }},
      watchdog1{"watchdog1", line(L4_WATCHDOG0_ID + 1),
                [this] { reset_manager.reset(ResetManager::L4_WATCHDOG_1); }},
      uart0{"uart0", std::move(wires.console), line(UART0_ID),
            [this] {
                log_once(
                    "UART0: a character was written while the FIFO was full, and is lost as on "
                    "the board; wait until LSR (0xFFC02014) has bit 5");
            }},
      uart1{"uart1", [](char) {}, line(UART0_ID + 1), [] {}, {}},
      i2c0{"i2c0", line(I2C0_ID)},
      i2c1{"i2c1", line(I2C0_ID + 1)},
      i2c2{"i2c2", line(I2C0_ID + 2)},
      i2c3{"i2c3", line(I2C0_ID + 3)},
      gpio0{"gpio0", line(GPIO0_ID)},
      gpio1{"gpio1", line(GPIO0_ID + 1)},
      gpio2{"gpio2", line(GPIO0_ID + 2)},
      spi_master0{"spi_master0", SpiController::Role::MASTER, line(SPI_ID)},
      spi_master1{"spi_master1", SpiController::Role::MASTER, line(SPI_ID + 1)},
      spi_slave0{"spi_slave0", SpiController::Role::SLAVE, line(SPI_ID + 2)},
      spi_slave1{"spi_slave1", SpiController::Role::SLAVE, line(SPI_ID + 3)},
      dma{"dma",
          {std::move(wires.transfer),
           [this](unsigned event, bool up) { gic.set_level(DMA_ID + event, up); },
           line(DMA_ABORT_ID), [this](const std::string& line) { log_once(line); }}},
      reset_manager{
          "reset_manager",
          {std::move(wires.bridges), [this](std::uint32_t blocks) { reset_blocks(blocks); },
           [this] { log_once("the second processor was released; only the first is simulated"); },
           [this](bool cold) {
               reset_blocks(WATCHDOG0 | WATCHDOG1);
               reset_(cold);
           }}},
      fpga_manager{"fpga_manager",
                   {[this](const std::string& line) { log_once(line); }, std::move(wires.gpo),
                    std::move(wires.gpi)}},
      scu{"scu", remembering::scu()},
      l2_cache{"l2_cache", remembering::l2_cache(), remembering::l2_cache_after_preloader()},
      system_manager{"system_manager", remembering::system_manager()},
      l3{"l3", {}},
      sdram_control{"sdram_control", remembering::sdram_control(),
                    remembering::sdram_after_preloader()},
      scan_manager{"scan_manager", remembering::scan_manager()},
      clock_manager{"clock_manager", clock_manager::registers(),
                    [this](std::uint32_t offset) {
                        if (clock_manager::changes_a_clock(offset))
                            log_once(
                                "the clock manager was set again; the clocks stay as the "
                                "preloader set them: processor 800 MHz, L4_SP 100 MHz");
                    }},
      on_chip_ram{"on_chip_ram", 0x10000, sc_core::sc_time{10, sc_core::SC_NS}},
      reset_{std::move(wires.reset)},
      log_{std::move(wires.log)} {}

void Peripherals::reset_blocks(std::uint32_t permodrst) {
    if (permodrst & WATCHDOG0) watchdog0.reset();
    if (permodrst & WATCHDOG1) watchdog1.reset();
    I2cController* const buses[] = {&i2c0, &i2c1, &i2c2, &i2c3};
    for (unsigned n = 0; n < 4; ++n)
        if (permodrst & I2C0 << n) buses[n]->reset();
    SpiController* const spis[] = {&spi_master0, &spi_master1, &spi_slave0, &spi_slave1};
    for (unsigned n = 0; n < 4; ++n)
        if (permodrst & SPI_MASTER0 << n) spis[n]->reset();
    if (permodrst & DMA) dma.reset();
}

void Peripherals::log_once(const std::string& line) {
    if (logged_.insert(line).second) log_(line);
}

void Peripherals::bind(Bus& bus) {
    const auto add = [&bus](auto& target, const char* title, std::uint32_t base,
                            std::uint32_t size) {
        bus.window(title, base, size).bind(target.socket);
    };
    add(fpga_manager, "the FPGA manager", 0xFF706000, 0x1000);
    add(gpio0, "GPIO0 of the HPS", GPIO1_BASE - 0x1000, 0x1000);
    add(gpio1, "GPIO1 of the HPS", GPIO1_BASE, 0x1000);
    add(gpio2, "GPIO2 of the HPS", GPIO1_BASE + 0x1000, 0x1000);
    add(l3, "the L3 interconnect", 0xFF800000, 0x80000);
    add(uart0, "UART0", 0xFFC02000, 0x1000);
    add(uart1, "UART1", 0xFFC03000, 0x1000);
    add(sdram_control, "the DDR3's controller", 0xFFC20000, 0x20000);
    add(dma, "the DMA controller", 0xFFE01000, 0x1000);
    add(spi_slave0, "SPI slave 0", 0xFFE02000, 0x1000);
    add(spi_slave1, "SPI slave 1", 0xFFE03000, 0x1000);
    add(spi_master0, "SPI master 0", 0xFFF00000, 0x1000);
    add(spi_master1, "SPI master 1", 0xFFF01000, 0x1000);
    add(scan_manager, "the scan manager", 0xFFF02000, 0x1000);
    add(i2c0, "I2C0 of the HPS", 0xFFC04000, 0x1000);
    add(i2c1, "I2C1 of the HPS", 0xFFC05000, 0x1000);
    add(i2c2, "I2C2 of the HPS", 0xFFC06000, 0x1000);
    add(i2c3, "I2C3 of the HPS", 0xFFC07000, 0x1000);
    add(timer0, "HPS timer 0", 0xFFC08000, 0x1000);
    add(timer1, "HPS timer 1", 0xFFC09000, 0x1000);
    add(timer2, "HPS timer 2", 0xFFD00000, 0x1000);
    add(timer3, "HPS timer 3", 0xFFD01000, 0x1000);
    add(watchdog0, "watchdog 0 of the HPS", 0xFFD02000, 0x1000);
    add(watchdog1, "watchdog 1 of the HPS", 0xFFD03000, 0x1000);
    add(clock_manager, "the clock manager", 0xFFD04000, 0x1000);
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

std::optional<RunningCount> Peripherals::running(std::uint32_t address,
                                                 std::uint64_t now_ps) const {
    switch (address) {
        case 0xFFFEC200: return global_timer.running(false, now_ps);
        case 0xFFFEC204: return global_timer.running(true, now_ps);
        case 0xFFFEC604: return private_timer.running(now_ps);
        case 0xFFC08004: return timer0.running(now_ps);
        case 0xFFC09004: return timer1.running(now_ps);
        case 0xFFD00004: return timer2.running(now_ps);
        case 0xFFD01004: return timer3.running(now_ps);
        default: return {};
    }
}

void Peripherals::fpga_interrupts(std::uint64_t levels) {
    const std::uint64_t moved = levels ^ fpga_levels_;
    fpga_levels_ = levels;
    for (unsigned bit = 0; bit < 64; ++bit)
        if (moved >> bit & 1) gic.set_level(FPGA_ID + bit, levels >> bit & 1);
}

}  // namespace sim
