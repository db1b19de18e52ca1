// hps_gpio.h - one of the HPS's three GPIO blocks (Synopsys DW_apb_gpio).
//
//   +0x00 data   +0x04 direction (1 = output)   +0x30 interrupt enable   +0x34 mask (1 = off)
//   +0x38 type (1 = edge)   +0x3C polarity (1 = high, rising)   +0x40 status   +0x44 raw status
//   +0x48 debounce   +0x4C EOI (write 1)   +0x50 pins   +0x60 synchronise   +0x6C version
//
//   of GPIO1   bit 24  HPS_LED, 1 = lit      bit 25  HPS_KEY, 0 = pressed
//   of GPIO2   bit 3   INT1 of the accelerometer
//
// Pins that nothing drives read 1.  A pin that is lent to the FPGA (loan I/O) is what the design
// drives there.
//
// Source: Cyclone V HPS TRM, chapter General-Purpose I/O Interface; DE1-SoC user manual, 3.7.
//
// Not handled: debouncing (the register remembers).
#pragma once

#include <functional>
#include <vector>

#include "sim/hps/registers.h"

namespace sim {

class HpsGpio : public Registers {
public:
    static constexpr unsigned LED = 24, KEY = 25;

    enum Offset : std::uint32_t {  // of a register
        DATA = 0x00,
        DIRECTION = 0x04,
        ENABLE = 0x30,
        MASK = 0x34,
        TYPE = 0x38,
        POLARITY = 0x3C,
        STATUS = 0x40,
        RAW = 0x44,
        DEBOUNCE = 0x48,
        EOI = 0x4C,
        PINS = 0x50,
        SYNCHRONISE = 0x60,
        VERSION = 0x6C
    };

    HpsGpio(const sc_core::sc_module_name& module_name, std::function<void(bool up)> line)
        : Registers{module_name}, line_{std::move(line)} {}

    // Called with the processor's time when the LED goes on or off.
    void on_led(std::function<void(bool lit, const sc_core::sc_time& now)> notify) {
        notify_ = std::move(notify);
    }
    bool led() const { return pins() >> LED & 1 && (direction_ | lent_) >> LED & 1; }
    void press_key(bool pressed) { drive(KEY, !pressed); }
    void drive(unsigned pin, bool level);  // from outside
    // The design drives these pins to these levels, and no others.
    void lend(std::uint32_t driven, std::uint32_t levels, const sc_core::sc_time& now);
    // Called with the pins' levels at once, and when they have moved.
    void on_pins(std::function<void(std::uint32_t levels, const sc_core::sc_time& now)> notify) {
        notify_pins_.push_back(std::move(notify));
        notify_pins_.back()(pins(), sc_core::SC_ZERO_TIME);
    }

private:
    std::uint32_t read(std::uint32_t offset, const sc_core::sc_time& now) override;
    void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) override;

    std::uint32_t pins() const {
        const std::uint32_t own = (data_ & direction_) | (outside_ & ~direction_);
        return (lent_levels_ & lent_) | (own & ~lent_);
    }
    std::uint32_t raw() const;
    void pins_moved(std::uint32_t before, const sc_core::sc_time& now);

    static constexpr std::uint32_t ALL = 0x1FFFFFFF;  // 29 pins

    std::uint32_t data_ = 0, direction_ = 0, enable_ = 0, mask_ = 0, edge_type_ = 0, polarity_ = 0,
                  debounce_ = 0, synchronise_ = 0;
    std::uint32_t outside_ = ALL;  // what the board drives or pulls
    std::uint32_t captured_ = 0;   // edges
    std::uint32_t lent_ = 0, lent_levels_ = 0;
    std::function<void(bool)> line_;
    std::function<void(bool, const sc_core::sc_time&)> notify_ = [](bool, const auto&) {};
    std::vector<std::function<void(std::uint32_t, const sc_core::sc_time&)>> notify_pins_;
};

}  // namespace sim
