#include "sim/board/ps2_keyboard.h"

#include <utility>

#include "sim/board/scan_codes.h"

namespace sim {

using sc_core::sc_time;

namespace {

const sc_time key_time{20, sc_core::SC_MS};

constexpr std::uint8_t DEFAULT_RATE = 0x2B;  // 500 ms, then 10.9 per second

}  // namespace

enum Ps2Keyboard::Command : std::uint8_t { LAMPS = 0xED, ECHO = 0xEE, CODE_SET = 0xF0 };

Ps2Keyboard::Ps2Keyboard(const sc_core::sc_module_name& name, std::function<void()> moved)
    : Ps2Device{name, std::move(moved)} {
    SC_HAS_PROCESS(Ps2Keyboard);
    SC_THREAD(strike_keys);
    SC_THREAD(repeat);
}

// ---- The keys ----

void Ps2Keyboard::press(std::uint16_t key) {
    moves_.push_back({key, true});
    scan();
}

void Ps2Keyboard::release(std::uint16_t key) {
    moves_.push_back({key, false});
    scan();
}

void Ps2Keyboard::scan() {
    if (!ready()) return;
    for (; !moves_.empty(); moves_.pop_front()) {
        const auto [key, down] = moves_.front();
        if (down || key == repeating_) {
            repeating_ = down ? key : std::uint16_t{0};
            changed_.notify(sc_core::SC_ZERO_TIME);
        }
        if (enabled_) report(down ? make_code(key) : break_code(key));
    }
}

void Ps2Keyboard::repeat() {
    for (;;) {
        wait(changed_);
        for (sc_time pause = delay_; repeating_;) {
            wait(pause, changed_);
            const bool another = changed_.triggered();
            if (!another && enabled_ && idle()) report(repeat_code(repeating_));
            pause = another ? delay_ : period_;
        }
    }
}

void Ps2Keyboard::type(const std::string& text) {
    typed_.insert(typed_.end(), text.begin(), text.end());
    type_.notify(sc_core::SC_ZERO_TIME);
}

void Ps2Keyboard::strike_keys() {
    for (;;) {
        while (typed_.empty() || !ready()) wait(type_);
        const Stroke stroke = sim::stroke(typed_.front()).value();
        typed_.pop_front();
        if (stroke.shift) press(LEFT_SHIFT);
        press(stroke.key);
        wait(key_time);
        release(stroke.key);
        if (stroke.shift) release(LEFT_SHIFT);
        wait(key_time);
    }
}

// ---- The host ----

void Ps2Keyboard::start() {
    lamps_ = argument_of_ = 0;
    enabled_ = true;
    defaults();
    answer({PASSED});
    type_.notify(sc_core::SC_ZERO_TIME);
    scan();
}

void Ps2Keyboard::defaults() {
    drop_reports();
    repeating_ = 0;
    set_rate(DEFAULT_RATE);
}

void Ps2Keyboard::set_rate(std::uint8_t byte) {
    const unsigned period = (8u + (byte & 7u)) << (byte >> 3 & 3);  // in 1/240 s
    period_ = sc_time{period / 240.0, sc_core::SC_SEC};
    delay_ = sc_time{250.0 * (1 + (byte >> 5)), sc_core::SC_MS};
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
