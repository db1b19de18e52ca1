// adv7513.h - the DE10-Nano's HDMI transmitter (Analog Devices' ADV7513): its registers by I2C.
//
// At 0x39 (0x72 to write, 0x73 to read) a transfer's first byte is the register, which increments.
// It is powered down until bit 6 of register 0x41 is cleared, by the design, or before that by the
// boot loader of the SD card that comes with the board.
// A monitor is connected: hot plug detect and its sense are 1 in register 0x42.
//
// Source: ADV7513 Hardware User's Guide and Programming Guide.
//
// Not handled: sound; all other registers keep what is written, and have no effect; EDID; the
// interrupt; that the video data must be in the form that the registers say.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "sim/board/i2c_speed.h"
#include "sim/board/i2c_target.h"

namespace sim {

class Adv7513 {
public:
    // `log` gets what a person should know.
    explicit Adv7513(std::function<void(const std::string&)> log = [](const std::string&) {})
        : speed_{"ADV7513", 400'000, std::move(log)} {
        registers_[0x00] = 0x13;  // the chip's revision
        registers_[POWER] = POWER_DOWN | 0x10;
        registers_[0x42] = 0x70;
        registers_[0xF5] = 0x75;  // the chip's number
        registers_[0xF6] = 0x11;
    }

    // Levels of the I2C wires, its own pull included; pulls_sda_low() may differ after it.
    void drive_i2c(bool scl, bool sda, std::uint64_t time_ps) { control_.drive(scl, sda, time_ps); }
    bool pulls_sda_low() const { return control_.pulls_low(); }

    bool is_powered() const { return !(registers_[POWER] & POWER_DOWN); }

private:
    static constexpr std::uint8_t ADDRESS = 0x39, POWER = 0x41, POWER_DOWN = 0x40;

    static bool is_read_only(unsigned number) {
        return number == 0x00 || number == 0x42 || number == 0xF5 || number == 0xF6;
    }
    bool byte(unsigned number, std::uint8_t value) {
        if (number == 0) return value >> 1 == ADDRESS && speed_.answers(control_.shortest_ps());
        if (number == 1)
            pointer_ = value;
        else if (const std::uint8_t at = pointer_++; !is_read_only(at))
            registers_[at] = value;
        return true;
    }

    std::array<std::uint8_t, 256> registers_{};
    std::uint8_t pointer_ = 0;
    I2cSpeed speed_;
    I2cTarget control_{[this](unsigned number, std::uint8_t value) { return byte(number, value); },
                       [](unsigned, unsigned) {}, [this] { return registers_[pointer_++]; }};
};

}  // namespace sim
