// i2c_controller.h - one of the HPS's four I2C controllers (Synopsys DW_apb_i2c), as a master
//
//   0x00 con     0x04 tar     0x10 data_cmd: byte, bit 8 read, bit 9 STOP after it, bit 10 START
//   again before it    0x14 - 0x20 clocks of SCL high and low    0x2C - 0x34 interrupts, and 0x40 -
//   0x68 whose reading clears them    0x38, 0x3C thresholds    0x6C enable: bit 1 aborts
//   0x70 status    0x74, 0x78 bytes in the FIFOs, each of 64    0x80 why it has aborted    0x9C
//
// Bytes take the time of SCL's clocks at 100 MHz, nine for each, and one for a START and a STOP.
// When the FIFO of commands runs empty without STOP the master holds the bus.  A byte for which the
// FIFO of received ones has no room is lost, and so is a command for which there is none.
//
// Where the bus is routed to the FPGA, see connect(), it is that of the design, bit by bit
// (i2c_wires.h): the last byte of those that are read is the one with STOP, or before a START.
//
// Source: Cyclone V HPS TRM, chapter I2C Controller.
//
// Not handled: being a slave, other masters, 10-bit addresses (nobody answers), general call and
// START byte, DMA, high speed.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>

#include "sim/hps/i2c_wires.h"
#include "sim/hps/registers.h"
#include "sim/pins/pins.h"

namespace sim {

class I2cController : public Registers {
public:
    // `line`: the interrupt's level.
    I2cController(const sc_core::sc_module_name& module_name, std::function<void(bool up)> line);

    // What hangs on its bus; nothing does at first.
    void connect(I2cDevices* devices) { devices_ = devices; }
    // It is routed to the FPGA; before the program begins.  `moved` is to be called with what the
    // design does.
    void connect(FabricWires wires);
    void moved(std::uint64_t levels) { fabric_->moved(levels); }
    // As the reset manager resets the block.
    void reset();

private:
    enum Offset : std::uint32_t;  // of a register

    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time& now) override;
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) override;

    void serve();
    void finish_byte();
    void abort(std::uint32_t source);
    void drop(std::uint32_t source);
    void stop();
    void stopped();
    void send_byte();
    void enable(std::uint32_t value);
    void command(std::uint32_t value, const sc_core::sc_time& now);
    I2cWires::Times times() const;
    sc_core::sc_time bits(unsigned count) const;
    std::uint32_t raw() const;
    std::uint32_t clear(std::uint32_t interrupts);
    void update();

    std::uint32_t con_, tar_, sar_, ss_high_, ss_low_, fs_high_, fs_low_, mask_, rx_threshold_,
        tx_threshold_, hold_, setup_, spike_, dma_, dma_tx_, dma_rx_, general_call_;
    bool enabled_ = false, active_ = false;  // between START and STOP
    bool reads_ = false, busy_ = false;      // the transfer's direction; a byte is on the wires
    bool stops_ = false;                     // disabled or aborted: STOP after this byte
    bool addresses_ = false;                 // the byte on the wires is the address
    bool addressed_ = false;                 // which was acknowledged, for the next command
    bool aborted_ = false;                   // until the program has seen it
    bool up_ = false;                        // the interrupt
    std::uint32_t current_ = 0, raised_ = 0, abort_source_ = 0;
    std::deque<std::uint32_t> commands_;
    std::deque<std::uint8_t> received_;
    I2cDevices* devices_ = nullptr;
    std::unique_ptr<I2cWires> fabric_;       // or none
    bool ends_ = false, sent_stop_ = false;  // STOP alone is on its wires; it came with the byte
    std::function<void(bool)> line_;
    sc_core::sc_event step_;
};

}  // namespace sim
