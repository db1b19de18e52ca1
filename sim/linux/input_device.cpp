#include "sim/linux/input_device.h"

#include <algorithm>
#include <cerrno>

namespace sim {

namespace {

constexpr std::uint64_t PS_PER_MS = 1'000'000'000;

bool bit_of(const std::vector<std::uint8_t>& bits, unsigned number) {
    return number / 8 < bits.size() && (bits[number / 8] >> number % 8 & 1);
}

void set_bit(std::vector<std::uint8_t>& bits, unsigned number, bool on) {
    if (bits.size() <= number / 8) bits.resize(number / 8 + 1);
    const unsigned bit = 1u << number % 8, was = bits[number / 8];
    bits[number / 8] = static_cast<std::uint8_t>(on ? was | bit : was & ~bit);
}

}  // namespace

InputDevice::InputDevice(About about, Agenda& agenda, std::function<void()> notify)
    : about_{std::move(about)},
      agenda_{agenda},
      notify_{std::move(notify)},
      repeat_{agenda, [this] { repeat(); }} {
    codes_[input_event::SYN];
}

unsigned InputDevice::codes_of(std::uint16_t type) {
    switch (type) {
        case input_event::SYN: return 0x20;  // in EVIOCGBIT: the types
        case input_event::KEY: return 0x300;
        case input_event::REL: return 0x10;
        case input_event::ABS: return 0x40;
        case input_event::MSC: return 0x08;
        case input_event::SW: return 0x11;
        case input_event::LED: return 0x10;
        case input_event::SND: return 0x08;
        case input_event::FF: return 0x80;
        default: return 0;
    }
}

void InputDevice::can(std::uint16_t type, std::initializer_list<std::uint16_t> codes) {
    for (const std::uint16_t code : codes) set_bit(codes_[type], code, true);
}

void InputDevice::has_axis(std::uint16_t code, const Axis& axis) {
    can(input_event::ABS, {code});
    axes_[code] = axis;
}

bool InputDevice::has(std::uint16_t type, std::uint16_t code) const {
    const auto found = codes_.find(type);
    return found != codes_.end() && bit_of(found->second, code);
}

// In words of 32 bits, as the kernel has them.
std::vector<std::uint8_t> InputDevice::bits(std::uint16_t type, bool is_state) const {
    std::vector<std::uint8_t> all;
    const auto& from = is_state ? on_ : codes_;
    if (type == input_event::SYN && !is_state)
        for (const auto& [known, codes] : codes_) set_bit(all, known, true);
    else if (const auto found = from.find(type); found != from.end())
        all = found->second;
    all.resize((codes_of(type) + 31) / 32 * 4);
    return all;
}

int InputDevice::grab(const std::shared_ptr<InputListener>& listener, bool on) {
    const auto present = grabbed_.lock();
    if (on && present) return -EBUSY;
    if (!on && present != listener) return -EINVAL;
    grabbed_ = on ? listener : nullptr;
    return 0;
}

bool InputDevice::changes(std::uint16_t type, std::uint16_t code, int value) {
    switch (type) {
        case input_event::SYN: return true;
        case input_event::MSC: return has(type, code);
        case input_event::REL: return has(type, code) && value != 0;
        case input_event::KEY:
        case input_event::LED:
            if (!has(type, code)) return false;
            if (type == input_event::KEY && value == 2) return true;
            if (bit_of(on_[type], code) == (value != 0)) return false;
            set_bit(on_[type], code, value != 0);
            return true;
        case input_event::ABS: {
            const auto axis = axes_.find(code);
            return axis != axes_.end() && std::exchange(axis->second.value, value) != value;
        }
        case input_event::REP:
            return has(type) && code < repetition.size() && value >= 0 &&
                   std::exchange(repetition[code], static_cast<std::uint32_t>(value)) !=
                       static_cast<std::uint32_t>(value);
        default: return false;
    }
}

void InputDevice::event(std::uint16_t type, std::uint16_t code, int value) {
    if (!exists_ || !changes(type, code, value)) return;
    if (type == input_event::KEY && has(input_event::REP) && value != 2) {
        repeating_ = code;
        if (value == 0 || repetition[0] == 0)
            repeat_.cancel();
        else
            repeat_.set_in(repetition[0] * PS_PER_MS);
    }
    pass(type, code, value);
}

void InputDevice::pass(std::uint16_t type, std::uint16_t code, int value) {
    const std::uint64_t us = now_ns() / 1000;
    const InputEvent event{static_cast<std::uint32_t>(us / 1'000'000),
                           static_cast<std::uint32_t>(us % 1'000'000), type, code, value};
    const auto grabbed = grabbed_.lock();
    if (grabbed) grabbed->hear(event);
    listeners_.erase(std::remove_if(listeners_.begin(), listeners_.end(),
                                    [](const auto& listener) { return listener.expired(); }),
                     listeners_.end());
    for (std::size_t i = 0; i < listeners_.size() && !grabbed; ++i)
        if (const auto listener = listeners_[i].lock()) listener->hear(event);
    if (type == input_event::SYN) notify_();
}

void InputDevice::repeat() {
    if (!exists_ || !bit_of(on_[input_event::KEY], repeating_)) return;
    pass(input_event::KEY, repeating_, 2);
    pass(input_event::SYN, input_event::SYN_REPORT, 1);
    if (repetition[1] != 0) repeat_.set_in(repetition[1] * PS_PER_MS);
}

void InputDevice::disconnect() {
    exists_ = false;
    repeat_.cancel();
    notify_();
}

}  // namespace sim
