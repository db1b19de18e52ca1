// project_peripherals.h - the processor's peripherals whose signals a project routes to the FPGA
//
// By the primitives cyclonev_hps_interface_peripheral_uart and its kind, or as Platform Designer
// writes them where a peripheral's pins are "FPGA".  The design so has their wires; the pins of the
// board that they have else are not connected, such as UART0's serial port by USB.
//
// What the processor moves comes to the design at its time, exactly.  What the design moves has its
// time, too, but the program learns of it as of an interrupt of the FPGA's: when the design has run
// past it, within 32 us, or exactly where it accesses the peripheral.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "sim/chip/fpga_chip.h"
#include "sim/hps/fabric_wires.h"
#include "sim/hps/peripherals.h"
#include "sim/pins/fpga_model.h"

namespace sim {

class ProjectPeripherals final : ProcessorWires {
public:
    // `log`: what a person should know.
    ProjectPeripherals(Peripherals& hps, FpgaChip& fpga,
                       const std::function<void(const std::string&)>& log);

private:
    void moved(Peripheral which, std::uint64_t levels, std::uint64_t time_ps) override;
    FabricWires wires(Peripheral which);
    void drive(Peripheral which, std::uint64_t levels, const sc_core::sc_time& now);
    void catch_up(const sc_core::sc_time& until);

    std::array<I2cController*, 4> i2c();
    std::array<SpiController*, 4> spi();

    Peripherals& hps_;
    FpgaChip& fpga_;
    bool is_told_ = false;  // by the design, which runs
};

}  // namespace sim
