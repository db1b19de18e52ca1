// wm8731.h - "WM8731 audio codec" (Wolfson, rev. 4.9) at its pins: I2C set-up, DAC data, ADC data.
//
// Control: answers at 0x1A (CSB low) to words of a 7-bit register and 9 bits of data, and counts a
// word when its last byte is complete.  It refuses a read, and registers other than 0 - 9 and 15.
// R15 = 0 sets all registers to their defaults.  It does not answer an SCL that is much faster than
// 526 kHz (i2c_speed.h).
//
// Sound: takes DACDAT and gives ADCDAT in the format of R7, in step with BCLK and each LRCK.  Every
// frame of DACLRCK is one sample for the sink: zeros while R9 is not active, R5 mutes, R6 powers
// down the DAC, the outputs or the chip, or R4 does not select the DAC.  The ADC has what is at
// LINE IN or at the microphone, by R4: zeros while R9 is not active, R6 powers down that input, the
// ADC or the chip, or R0, R1 or R4 mutes it.
//
// With MS in R7 it is the bus master: it drives BCLK and both LRCKs, which run while R9 is active
// and XCK runs (wm8731_clocks.h).  A slave takes those of the FPGA at any rate.
//
// Not handled: volumes and the microphone's gain, filters, bypass and sidetone; whether a slave's
// LRCK fits XCK and R8; the delays of the pins (ADCDAT moves with BCLK's edge).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "sim/board/digital_audio.h"
#include "sim/board/i2c_speed.h"
#include "sim/board/i2c_target.h"
#include "sim/board/wm8731_clocks.h"
#include "sim/pins/pins.h"

namespace sim {

class Wm8731 {
public:
    // Levels at the chip's pins; sda is the wire's level, with the chip's own pull included.
    struct Pins {
        bool bclk, daclrck, adclrck, dacdat, sclk, sda;
        bool clocks_driven = false;  // from outside: BCLK or an LRCK
    };
    using Sink = std::function<void(const StereoSample& sample, std::uint64_t time_ps)>;
    using Source = std::function<StereoSample()>;

    // The input that R4 selects is sampled once per frame of ADCLRCK; without a source it is
    // silent.  The microphone's left channel is used for both channels.
    explicit Wm8731(Sink sink, Source line_in = {}, Source microphone = {});
    Wm8731(const Wm8731&) = delete;
    Wm8731& operator=(const Wm8731&) = delete;

    // Call when a pin may have changed; adcdat(), pulls_sda_low() and clocks() may differ after it.
    void drive(const Pins& pins, std::uint64_t time_ps);
    bool adcdat() const { return adcdat_; }
    bool pulls_sda_low() const { return control_.pulls_low(); }

    // What it drives as the bus master.  xck() says the period of XCK, 0 if there is none; and
    // bclk_edge() that BCLK's next edge is due.
    const CodecClocks& clocks() const { return clocks_; }
    void xck(std::uint64_t period_fs);
    void bclk_edge();

    // Fault for tests: the chip does not answer to I2C word `number`, where 1 is the first of all.
    void refuse_word(std::uint64_t number) { refuse_word_ = number; }

    static constexpr unsigned REGISTERS = 10;
    // 9 bits, R0 to R9; a write with a BOTH bit has changed the other channel's register too.
    std::uint16_t reg(unsigned number) const { return registers_.at(number); }

    std::uint64_t words() const { return words_; }  // that began with the chip's address
    std::uint64_t refused_words() const { return refused_words_; }
    std::uint64_t samples() const { return samples_; }

    std::uint64_t time_ps() const { return now_ps_; }  // of the last drive()
    // Rate of DACLRCK, from two frames in a row that agree within 1 %. It changes only when later
    // frames differ by more than that.  0: not known yet.
    double rate_hz() const;

    // Why a chip that somebody wanted to use was not heard; empty: it was, or nobody did.
    std::string silence() const;

    std::uint64_t error_count() const { return error_count_; }
    // The first 20 that differ: "0.001234000 s: DACDAT: slots of 16 BCLKs for words of 24 bits".
    const std::vector<std::string>& errors() const { return errors_; }

private:
    bool byte(unsigned number, std::uint8_t value);
    bool refuse(const std::string& why);
    void end_of_transfer(unsigned bytes, unsigned bits);
    void write(unsigned number, std::uint16_t value);
    void apply();
    void apply_clocks();
    void check_timing(const Pins& was, bool sampling);
    void frame(const AudioReceiver::Frame& frame);
    void measure_rate();
    StereoSample input();
    void error(const std::string& text);

    Sink sink_;
    Source line_in_, microphone_;
    I2cTarget control_;
    I2cSpeed speed_{"WM8731", 526'000, [this](const std::string& text) { error(text); }};
    AudioReceiver dac_;
    AudioTransmitter adc_;
    Pins pins_{false, false, false, false, true, true};
    std::uint64_t now_ps_ = 0;
    bool adcdat_ = false;
    CodecClocks clocks_;
    Wm8731Clocks generator_;
    std::uint64_t xck_fs_ = 0;

    std::array<std::uint16_t, REGISTERS> registers_;
    std::uint8_t first_byte_ = 0;
    std::uint64_t words_ = 0, refused_words_ = 0, refuse_word_ = 0;

    // The decoded registers.
    AudioFormat format_;
    bool inverted_ = false;  // BCLK samples when it falls
    bool active_ = false, audible_ = false, swapped_ = false;

    // Since the beginning.
    bool bclk_moved_ = false, dacdat_moved_ = false, xck_moved_ = false, was_active_ = false,
         was_audible_ = false;

    std::uint64_t moved_ps_ = 0, sampled_ps_ = 0;  // DACLRCK or DACDAT; BCLK
    std::uint64_t frame_ps_ = 0;                   // when the last frame ended; 0: none did
    std::uint64_t last_period_ps_ = 0, period_ps_ = 0;
    std::uint64_t samples_ = 0, error_count_ = 0;
    std::set<std::string> reported_;
    std::vector<std::string> errors_;
};

}  // namespace sim
