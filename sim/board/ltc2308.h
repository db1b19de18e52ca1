// ltc2308.h - "LTC2308 low noise, 500 ksps, 8-channel, 12-bit ADC" (Linear Technology) at its pins.
//
//     CONVST  rises: converts for 1.6 us what the previous word has chosen
//     SDI     a word of 6 bits, as SCK rises: S/D O/S S1 S0 UNI SLP
//     SDO     the result, highest bit first, from the end of the conversion; moves as SCK falls
//
// Unipolar 0 to 4.095 V, bipolar -2.048 to 2.047 V (two's complement), 1 mV per step, clipped; COM
// is grounded on the DE1-SoC.  After power-on the word is 0: differential, CH0 - CH1, bipolar.
//
// Not handled: SLP, noise, and how long the inputs take to settle; SDO is low where it is open.
#pragma once

#include <array>
#include <cstdint>

#include "sim/board/part.h"

namespace sim {

class Ltc2308 : public Part {
public:
    static constexpr unsigned CHANNELS = 8;
    static constexpr std::uint64_t CONVERSION_PS = 1'600'000;

    // Millivolts at input `channel` against ground; converted from the next CONVST on.
    void set(unsigned channel, int millivolts) { inputs_.at(channel) = millivolts; }
    int millivolts(unsigned channel) const { return inputs_.at(channel); }

    // Call when a pin may have changed; sdo() is the level from then on.
    void drive(bool convst, bool sck, bool sdi, std::uint64_t time_ps);
    bool sdo() const { return !converting_ && (result_ & 0x800) != 0; }

    std::uint64_t conversions() const { return conversions_; }
    // Conversions begun, or SCK risen, while one was in progress: the result is then lost.
    std::uint64_t disturbed() const { return disturbed_; }

private:
    unsigned convert() const;

    std::array<int, CHANNELS> inputs_{};
    bool convst_ = false, sck_ = false, sdi_ = false;
    bool converting_ = false;
    std::uint64_t since_ps_ = 0;  // of the conversion
    unsigned word_ = 0, bits_ = 0;
    unsigned result_ = 0;  // its remaining bits, the next one in bit 11
    std::uint64_t conversions_ = 0, disturbed_ = 0;
};

}  // namespace sim
