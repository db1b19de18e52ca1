// wm8731_bench.h - test fixture: a WM8731 with an I2C master and a BCLK made by hand.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/board/wm8731.h"

namespace tb {

constexpr std::uint64_t QUARTER_PS = 2'500'000;  // of an SCL period: 100 kHz
constexpr std::uint64_t HALF_BCLK_PS = 160'000;  // 3.125 MHz

// R7 by its fields.
constexpr unsigned RIGHT = 0, LEFT = 1, I2S = 2, DSP = 3;
constexpr unsigned BITS16 = 0 << 2, BITS20 = 1 << 2, BITS24 = 2 << 2, BITS32 = 3 << 2;
constexpr unsigned LRP = 1 << 4, LRSWAP = 1 << 5, MASTER = 1 << 6, BCLKINV = 1 << 7;

class Wm8731Bench : public ::testing::Test {
protected:
    struct Heard {
        std::uint32_t left, right;
        bool operator==(const Heard& o) const { return left == o.left && right == o.right; }
        friend void PrintTo(const Heard& h, std::ostream* out) {
            *out << std::hex << h.left << "/" << h.right;
        }
    };

    std::vector<Heard> heard;
    sim::StereoSample line_in, microphone;
    unsigned asked = 0;
    std::uint64_t now_ps = 0;
    sim::Wm8731::Pins pins{false, true, true, false, true, true};
    bool master_sda = true;
    std::uint64_t quarter_ps = QUARTER_PS;
    std::string adc_bits;  // at the edges of BCLK that sample
    sim::Wm8731 chip{[this](const sim::StereoSample& s, std::uint64_t) {
                         heard.push_back({static_cast<std::uint32_t>(s.left),
                                          static_cast<std::uint32_t>(s.right)});
                     },
                     [this] {
                         ++asked;
                         return line_in;
                     },
                     [this] { return microphone; }};

    // ---- I2C ----

    void drive(std::uint64_t wait_ps) {
        now_ps += wait_ps;
        pins.sda = master_sda && !chip.pulls_sda_low();
        chip.drive(pins, now_ps);
        pins.sda = master_sda && !chip.pulls_sda_low();
    }
    void scl(bool level) {
        pins.sclk = level;
        drive(quarter_ps);
        drive(quarter_ps);
    }
    void sda(bool level) {
        master_sda = level;
        drive(quarter_ps);
    }
    void start() { sda(true), scl(true), sda(false), scl(false); }
    void stop() { sda(false), scl(true), sda(true); }
    // Whether it was acknowledged.
    bool byte(unsigned value) {
        for (int bit = 7; bit >= 0; --bit) sda(value >> bit & 1), scl(true), scl(false);
        sda(true);
        scl(true);
        const bool acknowledged = !pins.sda;
        scl(false);
        return acknowledged;
    }
    // The number of bytes that were acknowledged; a refusal ends the word.
    unsigned word(unsigned address, unsigned first, unsigned second) {
        start();
        unsigned count = 0;
        for (const unsigned value : {address, first, second}) {
            if (!byte(value)) break;
            ++count;
        }
        stop();
        return count;
    }
    unsigned set(unsigned reg, unsigned value) {
        return word(0x34, reg << 1 | value >> 8, value & 0xff);
    }
    void set_up(unsigned r7) {
        set(6, 0);      // everything on
        set(4, 0x010);  // DAC selected
        set(5, 0);      // not muted
        set(0, 0x017);
        set(1, 0x017);
        set(7, r7);
        set(9, 1);
    }

    // ---- Sound ----

    // One BCLK: LRCK and data move with the edge that does not sample.
    void bclk(bool lrck, bool data, bool inverted = false) {
        pins.bclk = inverted;
        pins.daclrck = pins.adclrck = lrck;
        pins.dacdat = data;
        drive(HALF_BCLK_PS);
        pins.bclk = !inverted;
        adc_bits += chip.adcdat() ? '1' : '0';
        drive(HALF_BCLK_PS);
    }
    // A slot: "1010" with LRCK at one level.
    void slot(bool lrck, const std::string& bits, bool inverted = false) {
        for (const char bit : bits) bclk(lrck, bit == '1', inverted);
    }
    static std::string binary(std::uint32_t value, unsigned bits) {  // the top ones
        std::string text;
        for (unsigned i = 0; i < bits; ++i) text += value >> (31 - i) & 1 ? '1' : '0';
        return text;
    }
};

}  // namespace tb
