#include "sim/board/ps2_keyboard.h"

#include "sim/board/scan_codes.h"

namespace sim {

using sc_core::sc_time;

namespace {

const sc_time self_test{500, sc_core::SC_MS}, key_time{20, sc_core::SC_MS};
const sc_time quarter{20, sc_core::SC_US};  // of a bit

constexpr std::uint8_t PASSED = 0xAA, ACKNOWLEDGE = 0xFA, RESEND = 0xFE, BREAK = 0xF0,
                       LEFT_SHIFT = 0x12;

bool odd(std::uint8_t byte) {
    bool odd = false;
    for (; byte; byte = static_cast<std::uint8_t>(byte & (byte - 1))) odd = !odd;
    return odd;
}

}  // namespace

Ps2Keyboard::Ps2Keyboard(const sc_core::sc_module_name& name, std::function<void()> moved)
    : sc_module{name}, moved_{std::move(moved)} {
    SC_HAS_PROCESS(Ps2Keyboard);
    SC_THREAD(serve);
    SC_THREAD(press_keys);
}

void Ps2Keyboard::type(const std::string& text) {
    keys_.insert(keys_.end(), text.begin(), text.end());
    key_.notify(sc_core::SC_ZERO_TIME);
}

void Ps2Keyboard::press_keys() {
    for (;;) {
        while (keys_.empty()) wait(key_);
        const char character = keys_.front();
        keys_.pop_front();
        const ScanCode key = scan_code(character).value();
        const auto send_if_on = [this](std::initializer_list<std::uint8_t> codes) {
            if (enabled_) to_send_.insert(to_send_.end(), codes);
            work_.notify(sc_core::SC_ZERO_TIME);
        };
        if (key.shift) send_if_on({LEFT_SHIFT});
        send_if_on({key.code});
        wait(key_time);
        send_if_on({BREAK, key.code});
        if (key.shift) send_if_on({BREAK, LEFT_SHIFT});
        wait(key_time);
    }
}

void Ps2Keyboard::host(bool clk_low, bool dat_low) {
    host_clk_low_ = clk_low;
    host_dat_low_ = dat_low;
    work_.notify(sc_core::SC_ZERO_TIME);
}

void Ps2Keyboard::drive(bool clk_low, bool dat_low) {
    clk_low_ = clk_low;
    dat_low_ = dat_low;
    moved_();
}

void Ps2Keyboard::reset() {
    to_send_.clear();
    argument_of_ = lamps_ = 0;
    enabled_ = false;
    wait(self_test);
    enabled_ = true;
    to_send_.push_back(PASSED);
}

void Ps2Keyboard::serve() {
    reset();
    for (;;) {
        if (!host_clk_low_ && host_dat_low_) {
            receive();
        } else if (!host_clk_low_ && !to_send_.empty()) {
            if (send(to_send_.front())) {
                last_ = to_send_.front();
                to_send_.pop_front();
            }
            wait(2 * quarter);
        } else {
            wait(work_);
        }
    }
}

bool Ps2Keyboard::send(std::uint8_t byte) {
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

void Ps2Keyboard::receive() {
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
        to_send_.push_front(RESEND);
}

void Ps2Keyboard::command(std::uint8_t byte) {
    if (argument_of_) {
        if (argument_of_ == 0xED) lamps_ = byte;
        argument_of_ = 0;
        to_send_ = {ACKNOWLEDGE};
        return;
    }
    switch (byte) {
        case 0xFF:
            while (!send(ACKNOWLEDGE)) wait(work_);
            reset();
            break;
        case 0xFE: to_send_.push_front(last_); break;
        case 0xF6: to_send_ = {ACKNOWLEDGE}; break;
        case 0xF5:
        case 0xF4:
            enabled_ = byte == 0xF4;
            to_send_ = {ACKNOWLEDGE};
            break;
        case 0xF3:
        case 0xED:
            argument_of_ = byte;
            to_send_ = {ACKNOWLEDGE};
            break;
        case 0xF2: to_send_ = {ACKNOWLEDGE, 0xAB, 0x83}; break;
        case 0xEE: to_send_ = {0xEE}; break;
        default: to_send_ = {RESEND}; break;
    }
}

}  // namespace sim
