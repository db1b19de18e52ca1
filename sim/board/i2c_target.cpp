#include "sim/board/i2c_target.h"

#include <algorithm>
#include <utility>

namespace sim {

void I2cTarget::drive(bool scl, bool sda, std::uint64_t time_ps) {
    const bool scl_was = std::exchange(scl_, scl), sda_was = std::exchange(sda_, sda);
    if (scl && scl_was) {
        if (sda != sda_was) begin_or_end(!sda);
    } else if (scl) {
        bit_ = sda_was;  // what moves with SCL's edge comes after it
        clocked_ = true;
        if (bits_ > 0 || bytes_ > 0) shortest_ps_ = std::min(shortest_ps_, time_ps - rose_ps_);
        rose_ps_ = time_ps;
    } else if (scl_was && std::exchange(clocked_, false) && listening_) {
        bit_ends();
    }
}

void I2cTarget::begin_or_end(bool start) {
    if (listening_) on_end_(bytes_, bits_);
    listening_ = start;
    acknowledging_ = clocked_ = reads_ = sending_ = false;
    bits_ = bytes_ = 0;
    shortest_ps_ = NONE;
}

// SCL has fallen: the bit is valid, because it can no longer turn into START or STOP.
void I2cTarget::bit_ends() {
    if (sending_) return sent_bit_ends();
    if (std::exchange(acknowledging_, false)) {
        sending_ = reads_;
        if (sending_) value_ = next_();
        return;
    }
    value_ = static_cast<std::uint8_t>(value_ << 1 | (bit_ ? 1 : 0));
    if (++bits_ < 8) return;
    bits_ = 0;
    listening_ = acknowledging_ = on_byte_(bytes_, value_);
    reads_ = bytes_ == 0 && value_ & 1;
    ++bytes_;
}

// The ninth bit is the master's.
void I2cTarget::sent_bit_ends() {
    if (++bits_ < 9) return;
    bits_ = 0;
    if (bit_)
        listening_ = sending_ = false;
    else
        value_ = next_();
}

}  // namespace sim
