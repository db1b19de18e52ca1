// audio_out.h - driver for the AUDIO block's output: never blocks.
#pragma once

#include <cstdint>

#include "hal/mmio.h"
#include "regmap.h"

namespace hal {

class AudioOut {
public:
    explicit AudioOut(Mmio& io) : io_{io} {}

    // Samples per second.
    unsigned rate_hz() const { return io_.read(regmap::CODEC_RATE); }

    // Stereo samples that fit now, 0 to 128.
    unsigned space() const {
        const std::uint32_t space = io_.read(regmap::AUDIO_FIFOSPACE);
        const std::uint32_t left = space >> regmap::AUDIO_FIFOSPACE_WSLC_LSB & 0xff;
        const std::uint32_t right = space >> regmap::AUDIO_FIFOSPACE_WSRC_LSB & 0xff;
        return left < right ? left : right;
    }

    // 32-bit samples, full scale; more than space() of them are lost.
    void push(std::int32_t left, std::int32_t right) {
        io_.write(regmap::AUDIO_LEFTDATA, static_cast<std::uint32_t>(left));
        io_.write(regmap::AUDIO_RIGHTDATA, static_cast<std::uint32_t>(right));
    }

private:
    Mmio& io_;
};

}  // namespace hal
