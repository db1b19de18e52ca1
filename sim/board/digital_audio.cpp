#include "sim/board/digital_audio.h"

#include <algorithm>
#include <utility>

namespace sim {

void AudioReceiver::format(const AudioFormat& format) {
    format_ = format;
    frame_.whole = false;
}

std::optional<AudioReceiver::Frame> AudioReceiver::sample(bool lrck, bool data) {
    std::optional<Frame> ended;
    const bool before = std::exchange(lrck_, lrck);
    const bool level = format_.late() ? before : lrck;
    const bool dsp = format_.framing == AudioFormat::DSP;
    if (std::exchange(level_, level) != level && (level || !dsp)) {
        frame_.least_bclks = std::min(frame_.least_bclks, bclks_);
        if (dsp || !format_.is_left(level)) frame_.sample.left = word(0);
        if (dsp || format_.is_left(level)) {
            frame_.sample.right = word(dsp ? 1 : 0);
            ended = frame_;
            if (!ended->whole) ended->sample = {};
            frame_ = {true, {}, ~0u};
        }
        bclks_ = 0;
    }
    if (bclks_ < 64 || format_.framing == AudioFormat::RIGHT) bits_ = bits_ << 1 | (data ? 1 : 0);
    ++bclks_;
    return ended;
}

std::int32_t AudioReceiver::word(unsigned number) const {
    const unsigned held = std::min(bclks_, 64u), last = (number + 1) * format_.bits;
    if (held == 0) return 0;  // else a shift by 64
    std::uint64_t bits = bits_;
    if (held < last)
        bits <<= last - held;  // too short: the missing bits are 0
    else if (format_.framing != AudioFormat::RIGHT)
        bits >>= held - last;
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(bits << (32 - format_.bits)));
}

void AudioTransmitter::format(const AudioFormat& format) { format_ = format; }

void AudioTransmitter::lrck(bool level) {
    level_ = level;
    if (format_.late())
        pending_ = true;
    else
        begin_slot();
}

void AudioTransmitter::sampled() {
    ++bclks_;
    if (std::exchange(pending_, false)) begin_slot();
}

void AudioTransmitter::begin_slot() {
    const bool dsp = format_.framing == AudioFormat::DSP;
    if (dsp && !level_) return;  // only the rising edge of LRCK matters
    slot_bclks_ = std::exchange(bclks_, 0u);
    const bool left = dsp || format_.is_left(level_);
    if (left) sample_ = next_();
    const auto bits_of = [](std::int32_t sample) {
        return std::uint64_t{static_cast<std::uint32_t>(sample)} << 32;
    };
    word_ = bits_of(left ? sample_.left : sample_.right);
    if (dsp) {
        word_ &= ~std::uint64_t{0} << (64 - format_.bits);
        word_ |= bits_of(sample_.right) >> format_.bits;
    }
}

bool AudioTransmitter::bit() const {
    unsigned position = bclks_;
    if (format_.framing == AudioFormat::RIGHT) {
        if (position + format_.bits < slot_bclks_) return false;
        position += format_.bits - slot_bclks_;
    }
    return position < format_.least_bclks() && (word_ >> (63 - position) & 1);
}

}  // namespace sim
