// adxl345_wires.h - an ADXL345 on pins of the FPGA, as on the DE10-Lite: SPI, or I2C.
//
//   CS_N low: SPI, mode 3    SDI in at a rise of SCLK, SDO out at its fall: read, several, 6 bits
//                            of the register; then bytes.  With bit 6 of register 0x31 SDI is both.
//   CS_N high: I2C           SCLK is SCL, SDI is SDA; the address is 0x1D where SDO is high, else
//                            0x53, as SDO is then an input
//
// Source: ADXL345 data sheet, revision G.
//
// Not handled: INT2, and INT1 in a project; SPI faster than 5 MHz works; a transfer of several
// bytes without the bit for it.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "sim/board/adxl345.h"
#include "sim/board/i2c_target.h"
#include "sim/pins/pins.h"

namespace sim {

class Adxl345Wires {
public:
    explicit Adxl345Wires(Adxl345& chip) : chip_{chip} {}

    void drive(const GsensorPins& pins, std::uint64_t time_ps) {
        now_ps_ = time_ps;
        alternate_ = pins.sdo;
        if (!pins.cs_n && cs_n_) {
            bits_ = 0;
            state_ = State::COMMAND;
            drives_ = false;
        } else if (pins.cs_n && !cs_n_) {
            chip_.end();
            drives_ = false;
        } else if (!pins.cs_n && pins.sclk != sclk_) {
            pins.sclk ? rise(pins.sdi) : fall();
        }
        if (pins.cs_n && cs_n_) i2c_.drive(pins.sclk, pins.sdi, time_ps);
        cs_n_ = pins.cs_n;
        sclk_ = pins.sclk;
    }

    // What it does with its wires now.
    bool pulls_sdi_low() const {
        return cs_n_ ? i2c_.pulls_low() : drives_ && three_wires_ && !level_;
    }
    bool pulls_sdo_low() const { return !cs_n_ && drives_ && !three_wires_ && !level_; }

private:
    enum class State { COMMAND, WRITE, READ };

    void rise(bool sdi) {
        if (state_ == State::READ) return;
        value_ = static_cast<std::uint8_t>(value_ << 1 | sdi);
        if (++bits_ % 8) return;
        if (state_ == State::WRITE) {
            if (register_ == FORMAT) three_wires_ = value_ & 0x40;
            ++register_;
            return chip_.write(value_, now_ps_);
        }
        register_ = value_ & 0x3F;
        chip_.begin(false);
        chip_.write(register_, now_ps_);
        state_ = value_ & 0x80 ? State::READ : State::WRITE;
        if (state_ == State::READ) chip_.begin(true);
    }
    void fall() {
        if (state_ != State::READ) return;
        if (bits_ % 8 == 0) value_ = chip_.read(now_ps_);
        level_ = value_ >> (7 - bits_++ % 8) & 1;
        drives_ = true;
    }

    bool byte(unsigned number, std::uint8_t value) {
        if (number == 0) {
            if (value >> 1 != (alternate_ ? 0x1D : Adxl345::ADDRESS)) return false;
            chip_.begin(value & 1);
        } else {
            chip_.write(value, now_ps_);
        }
        return true;
    }

    static constexpr std::uint8_t FORMAT = 0x31;

    Adxl345& chip_;
    I2cTarget i2c_{[this](unsigned number, std::uint8_t value) { return byte(number, value); },
                   [this](unsigned, unsigned) { chip_.end(); },
                   [this] { return chip_.read(now_ps_); }};
    std::uint64_t now_ps_ = 0;
    State state_ = State::COMMAND;
    bool cs_n_ = true, sclk_ = true, alternate_ = false;
    bool three_wires_ = false, drives_ = false, level_ = false;
    unsigned bits_ = 0;
    std::uint8_t value_ = 0, register_ = 0;
};

}  // namespace sim
