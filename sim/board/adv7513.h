// adv7513.h - the DE10-Nano's HDMI transmitter (Analog Devices' ADV7513): registers, and its sound.
//
// At 0x39 (0x72 to write, 0x73 to read) a transfer's first byte is the register, which increments.
// It is powered down until bit 6 of register 0x41 is cleared, by the design, or before that by the
// boot loader of the SD card that comes with the board.
// A monitor is connected: hot plug detect and its sense are 1 in register 0x42.
//
// Sound: takes I2S0 in the format of register 0x0C, in step with SCLK and LRCLK at any rate.  Every
// frame of LRCLK is one sample for the sink: zeros while the part is powered down, sends DVI
// (0xAF), sends no sound packets (0x44), takes S/PDIF (0x0A), has I2S0 off (0x0C), or N is 0 (0x01
// to 0x03).
//
// Source: ADV7513 Hardware User's Guide and Programming Guide; for sound, Linux' driver
// adv7511_audio.c, too; HDMI 1.4, 7.2, for N.
//
// Not handled: I2S1 to I2S3, S/PDIF, AES3 in I2S; MCLK; the rate and the word's length that the
// monitor is told (0x14, 0x15, 0x73); a CTS by hand; muting; all other registers keep what is
// written, and have no effect; EDID; the interrupt; that the video data must be in the form that
// the registers say.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "sim/board/digital_audio.h"
#include "sim/board/i2c_speed.h"
#include "sim/board/i2c_target.h"

namespace sim {

class Adv7513 {
public:
    using Sink = std::function<void(const StereoSample& sample)>;

    // `log` gets what a person should know, `sink` what is heard, left-justified.
    explicit Adv7513(
        std::function<void(const std::string&)> log = [](const std::string&) {}, Sink sink = {});
    Adv7513(const Adv7513&) = delete;
    Adv7513& operator=(const Adv7513&) = delete;

    // Levels of the I2C wires, its own pull included; pulls_sda_low() may differ after it.
    void drive_i2c(bool scl, bool sda, std::uint64_t time_ps) { control_.drive(scl, sda, time_ps); }
    bool pulls_sda_low() const { return control_.pulls_low(); }

    // Levels of SCLK, LRCLK and I2S0.
    void drive_sound(bool sclk, bool lrclk, bool data, std::uint64_t time_ps);

    bool is_powered() const;
    // Rate of LRCLK, from two frames in a row that agree within 1 %; 0: not known yet.
    double rate_hz() const { return period_ps_ ? 1e12 / static_cast<double>(period_ps_) : 0.0; }
    // Why sound that somebody sent was not heard; empty: it was, or nobody did.
    std::string silence() const;

private:
    static constexpr std::uint8_t ADDRESS = 0x39;
    // Registers and their bits.
    static constexpr std::uint8_t N_HIGH = 0x01, SOURCE = 0x0A, CLOCK = 0x0B, I2S = 0x0C,
                                  WIDTH = 0x0D, POWER = 0x41, PACKETS = 0x44, MODE = 0xAF;
    static constexpr unsigned SOURCE_MASK = 0x70, SCLK_FALLS = 0x40, I2S0_ON = 0x04,
                              FORMAT_MASK = 3, WIDTH_MASK = 0x1F, POWER_DOWN = 0x40,
                              SOUND_AND_N = 0x60, HDMI = 0x02;
    enum Format : unsigned { STANDARD, RIGHT, LEFT, AES3 };

    static bool is_read_only(unsigned number);
    bool byte(unsigned number, std::uint8_t value);
    void apply();
    void frame(const AudioReceiver::Frame& frame, std::uint64_t time_ps);
    unsigned n() const;
    const char* why_silent() const;  // null: it can be heard

    std::array<std::uint8_t, 256> registers_{};
    std::uint8_t pointer_ = 0;
    std::function<void(const std::string&)> log_;
    Sink sink_;
    AudioReceiver receiver_;
    bool sclk_ = false, data_ = false;
    bool data_moved_ = false, was_heard_ = false, judged_n_ = false;  // since the beginning
    std::uint64_t frame_ps_ = 0;  // when the last frame ended; 0: none did
    std::uint64_t last_period_ps_ = 0, period_ps_ = 0;
    I2cSpeed speed_;
    I2cTarget control_{[this](unsigned number, std::uint8_t value) { return byte(number, value); },
                       [](unsigned, unsigned) {}, [this] { return registers_[pointer_++]; }};
};

}  // namespace sim
