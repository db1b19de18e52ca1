#include "sim/board/ps2_device.h"

#include <utility>

namespace sim {

using sc_core::sc_time;

namespace {

const sc_time self_test{500, sc_core::SC_MS};
const sc_time quarter{20, sc_core::SC_US};  // of a bit
const sc_time shortest_hold{60 - 32, sc_core::SC_US};

bool odd(std::uint8_t byte) {
    bool odd = false;
    for (; byte; byte = static_cast<std::uint8_t>(byte & (byte - 1))) odd = !odd;
    return odd;
}

}  // namespace

Ps2Device::Ps2Device(const sc_core::sc_module_name& name, std::function<void()> moved)
    : sc_module{name}, moved_{std::move(moved)} {
    SC_HAS_PROCESS(Ps2Device);
    SC_THREAD(serve);
}

void Ps2Device::answer(const Bytes& bytes) {
    answers_.insert(answers_.end(), bytes.begin(), bytes.end());
    work_.notify(sc_core::SC_ZERO_TIME);
}

void Ps2Device::report(const Bytes& bytes) {
    reports_.insert(reports_.end(), bytes.begin(), bytes.end());
    work_.notify(sc_core::SC_ZERO_TIME);
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
    wait(self_test);
    ready_ = true;
    start();
}

void Ps2Device::serve() {
    test();
    for (;;) {
        std::deque<std::uint8_t>& bytes = answers_.empty() ? reports_ : answers_;
        const bool has_to_send = !answers_.empty() || (!reports_.empty() && may_report());
        if (!host_clk_low_ && host_dat_low_ && held_) {
            receive();
        } else if (!host_clk_low_ && !host_dat_low_ && has_to_send) {
            if (send(bytes.front())) {
                last_sent_ = bytes.front();
                bytes.pop_front();
                if (to_reset_ && answers_.empty()) test();
            }
            wait(2 * quarter);
        } else {
            wait(work_);
        }
    }
}

// ---- The wires ----

void Ps2Device::host(bool clk_low, bool dat_low) {
    if (clk_low && !host_clk_low_) held_since_ = sc_core::sc_time_stamp();
    if (!clk_low && host_clk_low_) held_ = sc_core::sc_time_stamp() - held_since_ >= shortest_hold;
    host_clk_low_ = clk_low;
    host_dat_low_ = dat_low;
    work_.notify(sc_core::SC_ZERO_TIME);
}

void Ps2Device::drive(bool clk_low, bool dat_low) {
    clk_low_ = clk_low;
    dat_low_ = dat_low;
    moved_();
}

bool Ps2Device::send(std::uint8_t byte) {
    const unsigned frame = static_cast<unsigned>(byte) << 1 | (odd(byte) ? 0u : 0x200u) | 0x400u;
    for (unsigned bit = 0; bit < 11; ++bit) {
        if (host_clk_low_ && bit < 10) {
            drive(false, false);
            return false;
        }
        const bool low = !(frame >> bit & 1);
        drive(false, low);
        wait(quarter);
        drive(true, low);
        wait(2 * quarter);
        drive(false, low);
        wait(quarter);
    }
    drive(false, false);
    return true;
}

void Ps2Device::receive() {
    held_ = false;
    unsigned bits = 0;
    for (unsigned bit = 0; bit < 10; ++bit) {  // 8 of data, parity, stop
        wait(quarter);
        drive(true, false);
        wait(2 * quarter);
        drive(false, false);
        if (!host_dat_low_) bits |= 1u << bit;
        wait(quarter);
    }
    const auto byte = static_cast<std::uint8_t>(bits);
    const bool right = (bits >> 8 & 1) != odd(byte) && (bits >> 9 & 1);
    drive(false, true);
    wait(quarter);
    drive(true, true);
    wait(2 * quarter);
    drive(false, false);
    wait(quarter);
    if (right)
        command(byte);
    else
        answer({RESEND});
}

}  // namespace sim
