#include "sim/board/serial_terminal.h"

#include <utility>

#include <fmt/format.h>

namespace sim {

namespace {

constexpr unsigned FRAME_BITS = 10;  // with start and stop

}  // namespace

SerialTerminal::SerialTerminal(HeaderPin rx, HeaderPin tx, unsigned baud, const PartSocket& socket)
    : rx_{rx}, tx_{mask_of({tx})}, baud_{baud}, socket_{socket} {
    socket_.drive(tx_, PinLevel::HIGH);
}

void SerialTerminal::look(const HeaderMasks& levels, std::uint64_t) {
    const bool before = std::exchange(level_, is_high(levels, rx_));
    if (!before || level_ || sampling_.is_set()) return;
    begin_ps_ = socket_.agenda.now_ps();
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
    sending_since_ps_ = socket_.agenda.now_ps();
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
    const bool one = sent_ > 0 && (sent_ == FRAME_BITS - 1 || (byte >> (sent_ - 1) & 1));
    socket_.drive(tx_, one ? PinLevel::HIGH : PinLevel::LOW);
    socket_.moved();
    ++sent_;
    sending_.set(after(sending_since_ps_, 2 * sent_));
}

std::optional<PartReport> SerialTerminal::final_report(const std::string& name, std::uint64_t) {
    PartReport told{name};
    told.received = received_;
    told.lost = lost_;
    if (lost_)
        told.advice.push_back(fmt::format(
            "terminal {}: {} bytes were lost, their stop bit is low; expected the rate of the "
            "FPGA's transmitter",
            name, lost_));
    return told;
}

}  // namespace sim
