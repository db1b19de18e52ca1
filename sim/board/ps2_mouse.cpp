#include "sim/board/ps2_mouse.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace sim {

namespace {

constexpr std::uint8_t FAILURE = 0xFC;
constexpr std::array<std::uint8_t, 3> ASKS_FOR_WHEEL{200, 100, 80};

int twofold(int counts) {
    constexpr int FEW[] = {0, 1, 1, 3, 6, 9};
    const int size = std::abs(counts), scaled = size < 6 ? FEW[size] : 2 * size;
    return counts < 0 ? -scaled : scaled;
}

}  // namespace

enum Ps2Mouse::Command : std::uint8_t {
    SCALE_1 = 0xE6,
    SCALE_2 = 0xE7,
    RESOLUTION = 0xE8,
    STATUS = 0xE9,
    STREAM = 0xEA,
    READ = 0xEB,
    UNWRAP = 0xEC,
    WRAP = 0xEE,
    REMOTE = 0xF0
};

Ps2Mouse::Ps2Mouse(Agenda& agenda, std::function<void()> moved)
    : Ps2Device{agenda, std::move(moved)} {}

// ---- The hand ----

void Ps2Mouse::Counter::add(int quarters) {
    rest += quarters;
    counts += rest / 4;
    rest %= 4;
    overflow = overflow || std::abs(counts) > MOST;
    counts = std::clamp(counts, -MOST, MOST);
}

void Ps2Mouse::move(int right, int up) {
    listener_.move(right, up);
    x_.add(right * (1 << resolution_));
    y_.add(up * (1 << resolution_));
    stir();
}

void Ps2Mouse::turn(int notches) {
    listener_.turn(notches);
    wheel_ += notches;
    stir();
}

void Ps2Mouse::button(MouseButton which, bool down) {
    listener_.button(which, down);
    const unsigned bit = 1u << static_cast<unsigned>(which);
    buttons_ = down ? buttons_ | bit : buttons_ & ~bit;
    stir();
}

void Ps2Mouse::stir() {
    stirred_ = true;
    look_at_stream();
}

// ---- Packets ----

void Ps2Mouse::look_at_stream() {
    constexpr std::uint64_t SECOND_PS = 1'000'000'000'000;
    if (stirred_ && streams() && !stream_.is_set()) stream_.set_in(SECOND_PS / rates_.back());
}

void Ps2Mouse::stream() {
    if (stirred_ && streams() && idle()) {
        last_ = packet(true);
        report(last_);
    }
    look_at_stream();
}

Ps2Mouse::Bytes Ps2Mouse::packet(bool scaled) {
    unsigned first = 0x08 | buttons_;
    const auto axis = [&](const Counter& counter, unsigned sign, unsigned overflow) {
        const int value = scaled && twice_ ? twofold(counter.counts) : counter.counts;
        const int sent = std::clamp(value, -MOST, MOST);
        if (sent < 0) first |= sign;
        if (counter.overflow || sent != value) first |= overflow;
        return static_cast<std::uint8_t>(sent);
    };
    const std::uint8_t x = axis(x_, 0x10, 0x40), y = axis(y_, 0x20, 0x80);
    Bytes bytes{static_cast<std::uint8_t>(first), x, y};
    if (has_wheel_) bytes.push_back(static_cast<std::uint8_t>(std::clamp(wheel_, -8, 7)));
    forget();
    return bytes;
}

void Ps2Mouse::forget() {
    x_ = y_ = {};
    wheel_ = 0;
    stirred_ = false;
}

// ---- The host ----

void Ps2Mouse::start() {
    defaults();
    wraps_ = has_wheel_ = refused_ = false;
    argument_of_ = 0;
    reply({PASSED, 0x00});
}

void Ps2Mouse::defaults() {
    rates_ = {0, 0, 100};
    resolution_ = 2;
    on_ = remote_ = twice_ = false;
    forget();
}

void Ps2Mouse::reply(const Bytes& bytes) {
    refused_ = false;
    last_ = bytes;
    answer(bytes);
}

void Ps2Mouse::refuse() {
    answer({refused_ ? FAILURE : RESEND});
    refused_ = !refused_;
}

void Ps2Mouse::command(std::uint8_t byte) {
    drop_reports();
    if (byte == AGAIN && !wraps_) return answer(last_);
    if (byte == RESET)
        reset();
    else if (wraps_ && byte != UNWRAP)
        answer({byte});
    else if (argument_of_)
        argument(std::exchange(argument_of_, std::uint8_t{0}), byte);
    else
        execute(byte);
    if (byte != READ) forget();
    look_at_stream();
}

void Ps2Mouse::argument(std::uint8_t of, std::uint8_t byte) {
    constexpr std::uint8_t RATES[] = {10, 20, 40, 60, 80, 100, 200};
    if (of == RESOLUTION && byte <= 3) {
        resolution_ = byte;
    } else if (of == RATE && std::count(std::begin(RATES), std::end(RATES), byte)) {
        rates_ = {rates_[1], rates_[2], byte};
        has_wheel_ = has_wheel_ || rates_ == ASKS_FOR_WHEEL;
    } else {
        return refuse();
    }
    reply({ACKNOWLEDGE});
}

void Ps2Mouse::execute(std::uint8_t command) {
    const auto flag = [](bool set, unsigned bit) { return set ? bit : 0u; };
    switch (command) {
        case SCALE_1: twice_ = false; break;
        case SCALE_2: twice_ = true; break;
        case STREAM: remote_ = false; break;
        case REMOTE: remote_ = true; break;
        case WRAP: wraps_ = true; break;
        case UNWRAP: wraps_ = false; break;
        case ON: on_ = true; break;
        case OFF: on_ = false; break;
        case DEFAULTS: defaults(); break;
        case RATE:
        case RESOLUTION: argument_of_ = command; break;
        case IDENTITY: return reply({ACKNOWLEDGE, static_cast<std::uint8_t>(has_wheel_ ? 3 : 0)});
        case READ: {
            Bytes bytes = packet(false);
            bytes.insert(bytes.begin(), ACKNOWLEDGE);
            return reply(bytes);
        }
        case STATUS: {
            const unsigned buttons =
                flag(buttons_ & 1, 4) | flag(buttons_ & 4, 2) | flag(buttons_ & 2, 1);
            const unsigned first =
                flag(remote_, 0x40) | flag(on_, 0x20) | flag(twice_, 0x10) | buttons;
            return reply(
                {ACKNOWLEDGE, static_cast<std::uint8_t>(first), resolution_, rates_.back()});
        }
        default: return refuse();
    }
    reply({ACKNOWLEDGE});
}

}  // namespace sim
