#include "sim/board/ps2_keyboard.h"

#include <utility>

namespace sim {

namespace {

constexpr std::uint64_t KEY_TIME_PS = 20'000'000'000;  // 20 ms

constexpr std::uint8_t DEFAULT_RATE = 0x2B;  // 500 ms, then 10.9 per second

}  // namespace

enum Ps2Keyboard::Command : std::uint8_t { LAMPS = 0xED, ECHO = 0xEE, CODE_SET = 0xF0 };

Ps2Keyboard::Ps2Keyboard(Agenda& agenda, std::function<void()> moved)
    : Ps2Device{agenda, std::move(moved)} {}

// ---- The keys ----

void Ps2Keyboard::press(std::uint16_t key) {
    listener_(key, true);
    moves_.push_back({key, true});
    scan();
}

void Ps2Keyboard::release(std::uint16_t key) {
    listener_(key, false);
    moves_.push_back({key, false});
    scan();
}

void Ps2Keyboard::scan() {
    if (!ready()) return;
    for (; !moves_.empty(); moves_.pop_front()) {
        const auto [key, down] = moves_.front();
        if (down) {
            repeating_ = key;
            repeat_.set_in(delay_ps_);
        } else if (key == repeating_) {
            repeating_ = 0;
            repeat_.cancel();
        }
        if (enabled_) report(down ? make_code(key) : break_code(key));
    }
}

void Ps2Keyboard::repeat() {
    if (enabled_ && idle()) report(repeat_code(repeating_));
    repeat_.set_in(period_ps_);
}

void Ps2Keyboard::type(const std::string& text) {
    typed_.insert(typed_.end(), text.begin(), text.end());
    if (!strike_.is_set()) strike_.set_in(0);
}

void Ps2Keyboard::strike() {
    if (struck_) {
        release(struck_->key);
        if (struck_->shift) release(LEFT_SHIFT);
        struck_.reset();
    } else {
        if (typed_.empty() || !ready()) return;
        struck_ = stroke(typed_.front()).value();
        typed_.pop_front();
        if (struck_->shift) press(LEFT_SHIFT);
        press(struck_->key);
    }
    strike_.set_in(KEY_TIME_PS);
}

// ---- The host ----

void Ps2Keyboard::start() {
    lamps_ = argument_of_ = 0;
    enabled_ = true;
    defaults();
    answer({PASSED});
    if (!strike_.is_set()) strike_.set_in(0);
    scan();
}

void Ps2Keyboard::defaults() {
    drop_reports();
    repeating_ = 0;
    repeat_.cancel();
    set_rate(DEFAULT_RATE);
}

void Ps2Keyboard::set_rate(std::uint8_t byte) {
    constexpr std::uint64_t SECOND_PS = 1'000'000'000'000;
    const std::uint64_t period = (8u + (byte & 7u)) << (byte >> 3 & 3);  // in 1/240 s
    period_ps_ = period * SECOND_PS / 240;
    delay_ps_ = (1u + (byte >> 5)) * SECOND_PS / 4;
}

bool Ps2Keyboard::argument(std::uint8_t of, std::uint8_t byte) {
    if (of == LAMPS && byte < 0x08) {
        lamps_ = byte;
        answer({ACKNOWLEDGE});
    } else if (of == RATE && byte < 0x80) {
        set_rate(byte);
        answer({ACKNOWLEDGE});
    } else if (of == CODE_SET && byte == 2) {
        answer({ACKNOWLEDGE});
    } else if (of == CODE_SET && byte == 0) {
        answer({ACKNOWLEDGE, 2});
    } else {
        return false;
    }
    return true;
}

void Ps2Keyboard::command(std::uint8_t byte) {
    if (argument_of_ && argument(std::exchange(argument_of_, std::uint8_t{0}), byte)) return;
    switch (byte) {
        case RESET: reset(); break;
        case AGAIN: answer({last_sent()}); break;
        case ECHO: answer({ECHO}); break;
        case IDENTITY: answer({ACKNOWLEDGE, 0xAB, 0x83}); break;
        case LAMPS:
        case RATE:
        case CODE_SET:
            argument_of_ = byte;
            answer({ACKNOWLEDGE});
            break;
        case ON:
            drop_reports();
            enabled_ = true;
            answer({ACKNOWLEDGE});
            break;
        case OFF:
        case DEFAULTS:
            defaults();
            if (byte == OFF) enabled_ = false;
            answer({ACKNOWLEDGE});
            break;
        default: answer({RESEND}); break;
    }
}

}  // namespace sim
