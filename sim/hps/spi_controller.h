// spi_controller.h - one of the HPS's SPI controllers (Synopsys DW_apb_ssi); nobody is on its wires
//
//   +0x00 ctrlr0: frame size less one 3:0, mode 9:8 (both, send, receive, EEPROM)   +0x04 ctrlr1:
//   frames to receive less one   +0x08 enable   +0x10 slaves   +0x14 divider of 200 MHz
//   +0x18, 0x1C thresholds   +0x20, 0x24 frames in the FIFOs, each of 256   +0x28 status
//   +0x2C - 0x48 interrupts   +0x60 - data   +0xFC
//
// A master sends while it is enabled, a slave is selected and there are frames, each in its
// bits' time; what comes back is 0.  A slave waits for a master for ever.  A frame for which a FIFO
// has no room is lost, which an interrupt says.
//
// Source: Cyclone V HPS TRM, chapter SPI Controller.
//
// Not handled: DMA, other formats than Motorola's (no difference without a device).
#pragma once

#include <deque>
#include <functional>
#include <utility>

#include "sim/hps/registers.h"

namespace sim {

class SpiController : public Registers {
public:
    enum class Role { MASTER, SLAVE };
    // `line`: the interrupt's level.
    SpiController(const sc_core::sc_module_name& module_name, Role role,
                  std::function<void(bool up)> line);

    // As the reset manager resets the block.
    void reset();

private:
    enum Offset : std::uint32_t;  // of a register

    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time& now) override;
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) override;

    void serve();
    void begin(const sc_core::sc_time& in);
    bool has_work() const;
    std::uint32_t raw() const;
    void update();

    const Role role_;
    std::function<void(bool)> line_;
    std::uint32_t control_ = 7, frames_ = 0, slaves_ = 0, divider_ = 0, tx_threshold_ = 0,
                  rx_threshold_ = 0, mask_ = 0, raised_ = 0, dma_ = 0, delay_ = 0;
    bool enabled_ = false, busy_ = false, up_ = false;
    std::uint32_t to_receive_ = 0;  // frames, of those that nothing is sent for
    std::deque<std::uint32_t> to_send_, received_;
    sc_core::sc_event step_;
};

}  // namespace sim
