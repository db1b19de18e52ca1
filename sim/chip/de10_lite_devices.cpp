#include "sim/chip/de10_lite_devices.h"

#include <algorithm>
#include <utility>

namespace sim {

// ---- The Arduino header -------------------------------------------------------------------------

ArduinoPort::ArduinoPort(De10LitePins& pins, std::function<void(bool)> interrupt)
    : pins_{pins}, interrupt_{std::move(interrupt)} {}

std::uint32_t ArduinoPort::read(std::uint32_t offset) const {
    switch (offset) {
        case 0x0: return pins_.arduino();
        case 0x4: return direction_;
        case 0x8: return mask_;
        default: return edges_;
    }
}

void ArduinoPort::write(std::uint32_t offset, std::uint32_t value) {
    const auto bits = static_cast<std::uint16_t>(value);
    switch (offset) {
        case 0x0: data_ = bits; break;
        case 0x4: direction_ = bits; break;
        case 0x8: mask_ = bits; break;
        default: edges_ = static_cast<std::uint16_t>(edges_ & ~bits); break;
    }
    if (offset < 0x8) pins_.drive_arduino(data_, direction_);
    settle();
}

void ArduinoPort::look() {
    const std::uint16_t now = pins_.arduino(), before = std::exchange(seen_, now);
    edges_ = static_cast<std::uint16_t>(edges_ | (before & ~now));
    settle();
}

void ArduinoPort::settle() {
    const bool up = edges_ & mask_;
    if (std::exchange(up_, up) != up) interrupt_(up);
}

// ---- The converter ------------------------------------------------------------------------------

namespace {

constexpr unsigned STEPS = 4096, FULL_MV = 5000;
constexpr std::uint32_t IS_NEW = 1 << 15;

}  // namespace

std::uint64_t Max10Converter::answers_ps(std::uint64_t now_ps) const {
    return again_ ? now_ps : std::max(now_ps, busy_until_ps_);
}

std::uint32_t Max10Converter::read(std::uint32_t offset, std::uint64_t now_ps) {
    const unsigned channel = offset / 4;
    if (channel >= CHANNELS) return 0;
    const std::uint64_t ended = rounds(now_ps);
    const bool fresh = ended > std::exchange(read_[channel], ended);
    if (now_ps < first_ps_) return 0;
    const auto mv = static_cast<unsigned>(std::max(pins_.analog_mv(channel), 0));
    return (fresh ? IS_NEW : 0) | std::min(mv * STEPS / FULL_MV, STEPS - 1);
}

void Max10Converter::write(std::uint32_t offset, std::uint32_t value, std::uint64_t now_ps) {
    if (offset == 0 && !again_ && now_ps >= busy_until_ps_) busy_until_ps_ = now_ps + ROUND_PS;
    const bool begins = offset == 4 && (value & 1) && !again_;
    if (offset == 4) again_ = value & 1;
    if (begins) {
        since_ps_ = now_ps;
        read_ = {};
    }
    if (begins || offset == 0) first_ps_ = std::min(first_ps_, now_ps + ROUND_PS);
}

// ---- The accelerometer --------------------------------------------------------------------------

namespace {

constexpr std::uint64_t HALF_A_BIT_PS = 8 * 10'000;
constexpr std::uint16_t READ = 1 << 15;

struct Setting {
    std::uint8_t number, value;
};
constexpr Setting SETTINGS[] = {
    {0x24, 0x20},  // activity: a change of 2 g
    {0x25, 0x03}, {0x26, 0x01},
    {0x27, 0x7F},  // of each axis; activity against the value of each sample
    {0x28, 0x09}, {0x29, 0x46},
    {0x2C, 0x09},                // 50 Hz
    {0x2E, 0x10}, {0x2F, 0x10},  // activity interrupts, at INT2
    {0x31, 0x40},                // three wires
    {0x2D, 0x08},                // measure
};

constexpr std::uint16_t word_of(std::uint8_t number, std::uint8_t value) {
    return static_cast<std::uint16_t>((number & 0x3F) << 8 | value);
}

}  // namespace

AccelerometerPort::AccelerometerPort(const sc_core::sc_module_name& name, De10LitePins& pins)
    : sc_module{name}, pins_{pins} {
    for (const Setting& setting : SETTINGS)
        wanted_.push_back({word_of(setting.number, setting.value), false});
    SC_HAS_PROCESS(AccelerometerPort);
    SC_THREAD(serve);
}

void AccelerometerPort::serve() {
    for (;;) {
        while (wanted_.empty()) wait(asked_);
        transfer(wanted_.front());
        wanted_.pop_front();
        done_.notify(sc_core::SC_ZERO_TIME);
    }
}

void AccelerometerPort::wires(bool cs_n, bool sclk, bool sdi) {
    sdi_ = pins_.drive_gsensor({cs_n, sclk, sdi, true}, sc_core::sc_time_stamp().value()) && sdi;
    wait(sc_core::sc_time::from_value(HALF_A_BIT_PS));
}

// SPI, mode 3: a bit goes out as SCLK falls, and is taken as it rises.
void AccelerometerPort::transfer(const Transfer& wanted) {
    std::uint16_t in = 0;
    wires(false, true, true);
    for (unsigned bit = 16; bit-- > 0;) {
        const bool released = wanted.reads && bit < 8;
        const bool out = released || (wanted.word >> bit & 1);
        wires(false, false, out);
        in = static_cast<std::uint16_t>(in << 1 | sdi_);
        wires(false, true, out);
    }
    wires(false, true, true);
    wires(true, true, true);
    if (wanted.reads) received_ = static_cast<std::uint8_t>(in);
}

void AccelerometerPort::await_idle() {
    while (!wanted_.empty()) wait(done_);
}

std::uint8_t AccelerometerPort::read(unsigned offset) {
    if (offset == 0) return address_;
    if (offset > 1) return 0;
    await_idle();
    wanted_.push_back({static_cast<std::uint16_t>(READ | word_of(address_, 0)), true});
    asked_.notify(sc_core::SC_ZERO_TIME);
    await_idle();
    return received_;
}

void AccelerometerPort::write(unsigned offset, std::uint8_t value) {
    if (offset == 0) address_ = value & 0x3F;
    if (offset != 1) return;
    await_idle();
    wanted_.push_back({word_of(address_, value), false});
    asked_.notify(sc_core::SC_ZERO_TIME);
}

}  // namespace sim
