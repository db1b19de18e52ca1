#include "sim/board/serial_terminal.h"

#include <utility>

namespace sim {

namespace {

constexpr unsigned FRAME_BITS = 10;  // with start and stop

}  // namespace

SerialTerminal::SerialTerminal(Agenda& agenda, unsigned baud, std::function<void(bool)> drive)
    : agenda_{agenda}, baud_{baud}, drive_{std::move(drive)} {}

void SerialTerminal::look(bool level) {
    const bool before = std::exchange(level_, level);
    if (!before || level || sampling_.is_set()) return;
    begin_ps_ = agenda_.now_ps();
    taken_ = 0;
    sampling_.set(after(begin_ps_, 1));
}

void SerialTerminal::sample() {
    if (taken_ == 0 && level_) return;  // too short for a start bit
    if (taken_ > 0 && taken_ < FRAME_BITS - 1)
        byte_ = static_cast<std::uint8_t>(byte_ >> 1 | (level_ ? 0x80 : 0));
    if (++taken_ < FRAME_BITS) return sampling_.set(after(begin_ps_, 2 * taken_ + 1));
    if (!level_) {
        ++lost_;
        return;
    }
    const char byte = static_cast<char>(byte_);
    if (received_.size() == 2 * MOST) received_.erase(0, MOST);
    received_ += byte;
    heard(byte);
}

void SerialTerminal::type(const std::string& text) {
    typed_.insert(typed_.end(), text.begin(), text.end());
    if (sending_.is_set() || typed_.empty()) return;
    sending_since_ps_ = agenda_.now_ps();
    sent_ = 0;
    sending_.set(sending_since_ps_);
}

void SerialTerminal::send() {
    if (sent_ == FRAME_BITS) {
        sending_since_ps_ = after(sending_since_ps_, 2 * FRAME_BITS);
        sent_ = 0;
        typed_.pop_front();
        if (typed_.empty()) return;
    }
    const auto byte = static_cast<std::uint8_t>(typed_.front());
    drive_(sent_ == 0 ? false : sent_ == FRAME_BITS - 1 || (byte >> (sent_ - 1) & 1));
    ++sent_;
    sending_.set(after(sending_since_ps_, 2 * sent_));
}

}  // namespace sim
