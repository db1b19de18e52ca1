#include "sim/board/ltc2308.h"

#include <algorithm>

namespace sim {

namespace {

constexpr unsigned SINGLE_ENDED = 0x20, ODD_SIGN = 0x10, UNIPOLAR = 0x02, WORD_BITS = 6;

}  // namespace

// The result for the channel that the last word has chosen, 12 bits.
unsigned Ltc2308::convert() const {
    const unsigned pair = word_ >> 2 & 3, odd = word_ & ODD_SIGN ? 1 : 0;
    const unsigned plus = 2 * pair + odd, minus = 2 * pair + (1 - odd);
    const int volts = inputs_[plus] - (word_ & SINGLE_ENDED ? 0 : inputs_[minus]);
    const int clipped =
        word_ & UNIPOLAR ? std::clamp(volts, 0, 4095) : std::clamp(volts, -2048, 2047);
    return static_cast<unsigned>(clipped) & 0xfff;
}

void Ltc2308::drive(bool convst, bool sck, bool sdi, std::uint64_t time_ps) {
    converting_ = converting_ && time_ps < since_ps_ + CONVERSION_PS;
    if (convst && !convst_) {
        if (converting_) ++disturbed_;
        result_ = convert();
        converting_ = true;
        since_ps_ = time_ps;
        bits_ = 0;
        ++conversions_;
    } else if (sck && !sck_) {
        if (converting_) {
            ++disturbed_;
            result_ = 0;
        }
        if (bits_ == 0) word_ = 0;
        if (bits_ < WORD_BITS) word_ |= (sdi_ ? 1u : 0u) << (WORD_BITS - 1 - bits_);
        ++bits_;
    } else if (!sck && sck_) {
        result_ = result_ << 1 & 0xfff;
    }
    convst_ = convst;
    sck_ = sck;
    sdi_ = sdi;
}

}  // namespace sim
