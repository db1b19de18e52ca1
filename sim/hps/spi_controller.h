// spi_controller.h - one of the HPS's SPI controllers (Synopsys DW_apb_ssi)
//
//   +0x00 ctrlr0: frame size less one 3:0, format 5:4, SCPH 6, SCPOL 7, mode 9:8 (both, send,
//   receive, EEPROM), slave's output off 10   +0x04 ctrlr1: frames to receive less one   +0x08
//   enable   +0x10 slaves   +0x14 divider of 200 MHz   +0x18, 0x1C thresholds   +0x20, 0x24 frames
//   in the FIFOs, each of 256   +0x28 status   +0x2C - 0x48 interrupts   +0x60 - data   +0xFC
//
// A master sends while it is enabled, a slave is selected and there are frames, each in its
// bits' time.  A frame for which a FIFO has no room is lost, which an interrupt says.
//
// Its wires are those of the design where they are routed to the FPGA, see connect()
// (spi_wires.h).  Else a master's frames go to pins, see on_frame(), from which 0 comes back, and a
// slave waits for ever.  A slave whose FIFO is empty sends 0.
//
// Source: Cyclone V HPS TRM, chapter SPI Controller.
//
// Not handled: DMA; other formats than Motorola's, in place of which that is used; a second master
// (ss_in_n of a master); the loopback (ctrlr0 bit 11).
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "sim/hps/registers.h"
#include "sim/hps/spi_wires.h"

namespace sim {

class SpiController : public Registers {
public:
    enum class Role { MASTER, SLAVE };
    // `line`: the interrupt's level.
    SpiController(const sc_core::sc_module_name& module_name, Role role,
                  std::function<void(bool up)> line);

    // It is routed to the FPGA; before the program begins.  `moved` is to be called with what the
    // design does.
    void connect(FabricWires wires);
    void moved(std::uint64_t levels, std::uint64_t time_ps);

    // Called with each frame that a master has sent to its pins, and the slaves that it has
    // selected.
    void on_frame(std::function<void(unsigned slaves, std::uint32_t frame)> notify) {
        sent_ = std::move(notify);
    }

    // As the reset manager resets the block.
    void reset();

private:
    enum Offset : std::uint32_t;  // of a register

    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time& now) override;
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) override;

    void serve();
    void begin(const sc_core::sc_time& in);
    void send();
    bool has_work() const;
    SpiFormat format() const;
    void receive(std::uint32_t frame);
    std::uint32_t next_of_slave() const;
    void release_wires();
    std::uint32_t raw() const;
    void update();

    const Role role_;
    std::function<void(bool)> line_;
    std::function<void(unsigned, std::uint32_t)> sent_ = [](unsigned, std::uint32_t) {};
    std::uint32_t control_ = 7, frames_ = 0, slaves_ = 0, divider_ = 0, tx_threshold_ = 0,
                  rx_threshold_ = 0, mask_ = 0, raised_ = 0, dma_ = 0, delay_ = 0;
    bool enabled_ = false, busy_ = false, up_ = false;
    bool is_over_ = true;           // at step_ the frame is over, else it begins
    std::uint32_t to_receive_ = 0;  // frames, of those that nothing is sent for
    std::uint32_t repeated_ = 0;    // what is sent meanwhile
    std::deque<std::uint32_t> to_send_, received_;
    sc_core::sc_event step_;
    std::optional<FabricWires> wires_;
    std::unique_ptr<SpiMasterWires> fabric_;  // of a master that is routed there
    std::optional<SpiSlaveWires> slave_;      // of a slave
    sc_core::sc_time moved_at_;               // what the slave answers
};

}  // namespace sim
