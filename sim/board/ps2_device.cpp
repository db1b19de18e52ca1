#include "sim/board/ps2_device.h"

#include <utility>

namespace sim {

namespace {

constexpr std::uint64_t SELF_TEST_PS = 500'000'000'000;  // 500 ms
constexpr std::uint64_t QUARTER_PS = 20'000'000;         // of a bit: 20 us
constexpr std::uint64_t SHORTEST_HOLD_PS = 60'000'000;   // 60 us
constexpr unsigned SENT_BITS = 11, RECEIVED_BITS = 10;   // the latter without start

bool odd(std::uint8_t byte) {
    bool odd = false;
    for (; byte; byte = static_cast<std::uint8_t>(byte & (byte - 1))) odd = !odd;
    return odd;
}

}  // namespace

Ps2Device::Ps2Device(Agenda& agenda, std::function<void()> moved)
    : agenda_{agenda}, moved_{std::move(moved)} {
    test();
}

void Ps2Device::answer(const Bytes& bytes) {
    answers_.insert(answers_.end(), bytes.begin(), bytes.end());
    look_for_work();
}

void Ps2Device::report(const Bytes& bytes) {
    reports_.insert(reports_.end(), bytes.begin(), bytes.end());
    look_for_work();
}

void Ps2Device::reset() {
    reports_.clear();
    answer({ACKNOWLEDGE});
    to_reset_ = true;
}

void Ps2Device::test() {
    to_reset_ = ready_ = false;
    answers_.clear();
    reports_.clear();
    begin(Doing::TEST, SELF_TEST_PS);
}

// ---- One thing after the other ----

void Ps2Device::begin(Doing doing, std::uint64_t first_ps) {
    doing_ = doing;
    part_ = 0;
    next_.set_in(first_ps);
}

// Now, but not before the present one is at its end.
void Ps2Device::look_for_work() {
    if (doing_ == Doing::NOTHING) next_.set_in(0);
}

void Ps2Device::work() {
    switch (doing_) {
        case Doing::SEND: return send();
        case Doing::RECEIVE: return receive();
        case Doing::TEST:
            ready_ = true;
            start();
            break;
        case Doing::REST:
        case Doing::NOTHING: break;
    }
    doing_ = Doing::NOTHING;
    if (host_clk_low_) return;
    const bool has_to_send = !answers_.empty() || (!reports_.empty() && may_report());
    if (host_dat_low_ && held_) {
        held_ = false;
        frame_ = 0;
        begin(Doing::RECEIVE, QUARTER_PS);
    } else if (!host_dat_low_ && has_to_send) {
        sending_ = answers_.empty() ? &reports_ : &answers_;
        const std::uint8_t byte = sending_->front();
        frame_ = static_cast<unsigned>(byte) << 1 | (odd(byte) ? 0u : 0x200u) | 0x400u;
        begin(Doing::SEND, 0);
    }
}

// ---- The wires ----

void Ps2Device::host(bool clk_low, bool dat_low) {
    const std::uint64_t now_ps = agenda_.now_ps();
    if (clk_low && !host_clk_low_) held_since_ps_ = now_ps;
    if (!clk_low && host_clk_low_) held_ = now_ps - held_since_ps_ >= SHORTEST_HOLD_PS;
    host_clk_low_ = clk_low;
    host_dat_low_ = dat_low;
    look_for_work();
}

void Ps2Device::drive(bool clk_low, bool dat_low, std::uint64_t for_ps) {
    clk_low_ = clk_low;
    dat_low_ = dat_low;
    moved_();
    next_.set_in(for_ps);
}

// A bit has three parts: DAT moves, CLK is low, CLK is high again.
void Ps2Device::send() {
    const unsigned bit = part_ / 3, moment = part_ % 3;
    const bool held_back = host_clk_low_ && bit + 1 < SENT_BITS;
    if (moment == 0 && (bit == SENT_BITS || held_back)) {
        if (bit == SENT_BITS) sent();
        if (doing_ == Doing::SEND) begin(Doing::REST, 2 * QUARTER_PS);
        clk_low_ = dat_low_ = false;
        return moved_();
    }
    ++part_;
    const bool low = !(frame_ >> bit & 1);
    drive(moment == 1, low, moment == 1 ? 2 * QUARTER_PS : QUARTER_PS);
}

void Ps2Device::sent() {
    last_sent_ = sending_->front();
    sending_->pop_front();
    if (to_reset_ && answers_.empty()) test();
}

// A bit has two parts: CLK is low, CLK is high again.  The last is the acknowledge.
void Ps2Device::receive() {
    constexpr unsigned ACKNOWLEDGES = 2 * RECEIVED_BITS;
    const unsigned part = part_++, bit = part / 2;
    if (part == ACKNOWLEDGES) return drive(false, true, QUARTER_PS);
    if (part == ACKNOWLEDGES + 1) return drive(true, true, 2 * QUARTER_PS);
    if (part == ACKNOWLEDGES + 2) return drive(false, false, QUARTER_PS);
    if (part > ACKNOWLEDGES + 2) return received();
    if (part % 2 == 0) return drive(true, false, 2 * QUARTER_PS);
    if (!host_dat_low_) frame_ |= 1u << bit;
    drive(false, false, bit + 1 == RECEIVED_BITS ? QUARTER_PS : 2 * QUARTER_PS);
}

void Ps2Device::received() {
    const auto byte = static_cast<std::uint8_t>(frame_);
    const bool right = (frame_ >> 8 & 1) != odd(byte) && (frame_ >> 9 & 1);
    doing_ = Doing::NOTHING;
    next_.set_in(0);
    if (right)
        command(byte);
    else
        answer({RESEND});
}

}  // namespace sim
