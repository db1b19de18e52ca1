// adv7180.h - the board's video decoder, and a camera that films a picture: ITU-R BT.656, 525 lines
//
//   FF 00 00 EAV | 80 10 ... 80 10 | FF 00 00 SAV | Cb Y Cr Y ... 720 pixels |
//   0              4                 272            276                        1716 clocks
//
//   The first field (F = 0) begins in line 4, the second one (F = 1) in line 266.  V rises in lines
//   1 and 264 and falls in lines 10 and 273, the chip's setting after power-up.  That is revision 3
//   of the standard; in revision 4 V falls in lines 20 and 283.
//
// The camera's picture is stretched to 720 x 480 pixels by nearest neighbour.  Rows 0, 2 ... are
// lines 22 to 261, rows 1, 3 ... are lines 285 to 524; the other lines are black.  Colours are by
// ITU-R BT.601, of every second pixel.  Without a camera the chip shows blue: DEF_VAL_AUTO_EN is
// set after a reset, DEF_Y and DEF_C say Y = 0x34, Cb = 0xC0, Cr = 0x70.
//
// It needs no set-up over I2C: after its reset it detects the signal and sends 8-bit BT.656.  At
// 0x40 and 0x41 (ALSB low, as on the board) its registers are written and read
// (adv7180_registers.h).  Of them DEF_Y, DEF_C and their enables count; others have no effect.
// RESET_N is an input from the FPGA; while it is low the chip stays in reset.
//
// Source: ITU-R BT.656 and BT.601; Analog Devices' ADV7180 datasheet.
//
// Not handled: HS and VS, what most registers do, PAL, the time that the chip takes to lock to a
// signal, the noise and the limited bandwidth of a real one.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "sim/board/adv7180_registers.h"
#include "sim/board/i2c_speed.h"
#include "sim/board/i2c_target.h"
#include "sim/board/part.h"
#include "sim/files/png.h"

namespace sim {

class Adv7180 : public Part {
public:
    static constexpr unsigned LINE_CLOCKS = 1716, LINES = 525;
    static constexpr unsigned WIDTH = 720, HEIGHT = 480;

    // `log` gets what a person should know.
    explicit Adv7180(std::function<void(const std::string&)> log = [](const std::string&) {})
        : speed_{"ADV7180", 400'000, std::move(log)} {}

    // The camera sees this picture from the next line on; null: there is no camera.
    void show(std::shared_ptr<const Image> picture);

    // Its data pins at a rise of its clock, the first of which is number 0 and begins line 1.
    std::uint8_t data(std::uint64_t rise) {
        if (rise / LINE_CLOCKS != line_) make_line(rise / LINE_CLOCKS);
        return bytes_[rise % LINE_CLOCKS];
    }

    // Levels of its I2C wires, its own pull included; pulls_sda_low() may differ after it.
    void drive_i2c(bool sclk, bool sda, std::uint64_t time_ps) {
        control_.drive(sclk, sda, time_ps);
    }
    bool pulls_sda_low() const { return control_.pulls_low(); }

private:
    static constexpr std::uint8_t ADDRESS = 0x20;

    void make_line(std::uint64_t line);
    void make_row(unsigned row);

    bool byte(unsigned number, std::uint8_t value);

    Adv7180Registers registers_;
    I2cSpeed speed_;
    I2cTarget control_{[this](unsigned number, std::uint8_t value) { return byte(number, value); },
                       [](unsigned, unsigned) {}, [this] { return registers_.read(); }};
    std::shared_ptr<const Image> picture_;
    std::uint64_t line_ = ~std::uint64_t{0};  // of the bytes, counted from the first one
    std::array<std::uint8_t, LINE_CLOCKS> bytes_{};
};

}  // namespace sim
