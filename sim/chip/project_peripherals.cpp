#include "sim/chip/project_peripherals.h"

#include <algorithm>
#include <utility>

namespace sim {

using sc_core::sc_time;

namespace {

constexpr std::uint32_t LENT_PINS = 0x1FFFFFFF;  // of a GPIO block
constexpr unsigned LENT_DRIVEN_LSB = 29;

}  // namespace

ProjectPeripherals::ProjectPeripherals(Peripherals& hps, FpgaChip& fpga,
                                       const std::function<void(const std::string&)>& log)
    : hps_{hps}, fpga_{fpga} {
    const FpgaModel& model = fpga.model();
    Uart* const uarts[] = {&hps.uart0, &hps.uart1};
    for (unsigned n = 0; n < 2; ++n)
        if (model.has({Peripheral::UART, n})) uarts[n]->connect(wires({Peripheral::UART, n}));
    if (hps.uart0.is_connected())
        log("UART0 is routed to the FPGA: the board's serial port by USB is not connected");
    const auto i2cs = i2c();
    for (unsigned n = 0; n < i2cs.size(); ++n)
        if (model.has({Peripheral::I2C, n})) i2cs[n]->connect(wires({Peripheral::I2C, n}));
    const auto spis = spi();
    for (const auto kind : {Peripheral::SPI_MASTER, Peripheral::SPI_SLAVE})
        for (unsigned n = 0; n < 2; ++n)
            if (model.has({kind, n}))
                spis[n + (kind == Peripheral::SPI_SLAVE ? 2 : 0)]->connect(wires({kind, n}));
    if (model.has({Peripheral::DMA, 0})) hps.dma.connect(wires({Peripheral::DMA, 0}));
    HpsGpio* const gpios[] = {&hps.gpio0, &hps.gpio1, &hps.gpio2};
    for (unsigned n = 0; n < 3; ++n)
        if (model.has({Peripheral::LOAN_IO, n}))
            gpios[n]->on_pins([this, n](std::uint32_t levels, const sc_time& now) {
                drive({Peripheral::LOAN_IO, n}, levels, now);
            });
    fpga.model().connect(*this);
}

std::array<I2cController*, 4> ProjectPeripherals::i2c() {
    return {&hps_.i2c0, &hps_.i2c1, &hps_.i2c2, &hps_.i2c3};
}

// The masters, then the slaves.
std::array<SpiController*, 4> ProjectPeripherals::spi() {
    return {&hps_.spi_master0, &hps_.spi_master1, &hps_.spi_slave0, &hps_.spi_slave1};
}

FabricWires ProjectPeripherals::wires(Peripheral which) {
    return {[this, which](std::uint64_t levels, const sc_time& now) { drive(which, levels, now); },
            [this](const sc_time& until) { catch_up(until); }};
}

// The design cannot be run where it runs already, and calls: a master of its own, or the board.
void ProjectPeripherals::catch_up(const sc_time& until) {
    if (!is_told_ && !fpga_.is_running()) fpga_.run_to(until.value());
}

void ProjectPeripherals::drive(Peripheral which, std::uint64_t levels, const sc_time& now) {
    catch_up(now);
    if (is_told_ || fpga_.is_running())
        fpga_.model().drive(which, levels, {});
    else
        fpga_.model().drive(which, levels, now.value());
}

void ProjectPeripherals::moved(Peripheral which, std::uint64_t levels, std::uint64_t time_ps) {
    const bool before = std::exchange(is_told_, true);
    switch (which.kind) {
        case Peripheral::UART:
            (which.number ? hps_.uart1 : hps_.uart0).moved(levels, time_ps);
            break;
        case Peripheral::I2C: i2c()[which.number]->moved(levels); break;
        case Peripheral::SPI_MASTER: spi()[which.number]->moved(levels, time_ps); break;
        case Peripheral::SPI_SLAVE: spi()[which.number + 2]->moved(levels, time_ps); break;
        case Peripheral::DMA: hps_.dma.moved(levels); break;
        case Peripheral::LOAN_IO: {
            HpsGpio* const gpios[] = {&hps_.gpio0, &hps_.gpio1, &hps_.gpio2};
            gpios[which.number]->lend(static_cast<std::uint32_t>(levels >> LENT_DRIVEN_LSB),
                                      static_cast<std::uint32_t>(levels) & LENT_PINS,
                                      sc_time::from_value(time_ps));
            break;
        }
        default: break;
    }
    is_told_ = before;
}

}  // namespace sim
