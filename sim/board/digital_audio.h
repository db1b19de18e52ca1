// digital_audio.h - both ends of a serial audio interface: bits in slots to samples, and back.
//
//            LEFT            RIGHT           I2S              DSP
//   LRCK     left high       left high       left low         rises before left, right follows
//   MSB      first BCLK      (LSB last)      second BCLK      first BCLK, or second with LRP
//
// "First BCLK" is the first edge that samples after LRCK has moved.  LRP exchanges the levels of
// LRCK in the first three.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

namespace sim {

// Left-justified: the sign is bit 31 for every word length.
struct StereoSample {
    std::int32_t left = 0, right = 0;
};

struct AudioFormat {
    enum Framing { RIGHT, LEFT, I2S, DSP };

    Framing framing = I2S;
    unsigned bits = 24;  // 16, 20, 24 or 32
    bool lrp = false;

    bool late() const { return framing == I2S || (framing == DSP && lrp); }
    bool is_left(bool lrck) const { return lrck != ((framing == I2S) != lrp); }
    unsigned least_bclks() const { return framing == DSP ? 2 * bits : bits; }  // in a slot
};

// Of two periods of LRCK in a row.
inline bool within_1_percent(std::uint64_t a, std::uint64_t b) {
    return 100 * (a > b ? a - b : b - a) <= b;
}

class AudioReceiver {
public:
    struct Frame {
        bool whole;  // seen from its beginning in one format; else the sample is 0
        StereoSample sample;
        unsigned least_bclks;  // of its slots
    };

    void format(const AudioFormat& format);

    // The wires at a BCLK edge that samples; a frame when its last slot has ended.
    std::optional<Frame> sample(bool lrck, bool data);

private:
    std::int32_t word(unsigned number) const;

    AudioFormat format_;
    Frame frame_{false, {}, ~0u};
    bool lrck_ = false;       // at the edge before
    bool level_ = false;      // LRCK of this slot
    std::uint64_t bits_ = 0;  // of this slot: the first 64, or the last 64 if justified right
    unsigned bclks_ = 0;      // of this slot
};

class AudioTransmitter {
public:
    explicit AudioTransmitter(std::function<StereoSample()> next) : next_{std::move(next)} {}

    void format(const AudioFormat& format);

    void lrck(bool level);  // it has moved
    void sampled();         // a BCLK edge at which the other end samples
    bool bit() const;       // for the next such edge

private:
    void begin_slot();

    std::function<StereoSample()> next_;  // called once per frame
    AudioFormat format_;
    StereoSample sample_;
    bool level_ = false;
    bool pending_ = false;     // a slot begins at the next edge
    std::uint64_t word_ = 0;   // of this slot, the first bit is 63
    unsigned bclks_ = 0;       // of this slot
    unsigned slot_bclks_ = 0;  // of the one before
};

}  // namespace sim
