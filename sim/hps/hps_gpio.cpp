#include "sim/hps/hps_gpio.h"

namespace sim {

namespace {

constexpr std::uint32_t VERSION_2_08 = 0x3230382A;

}  // namespace

std::uint32_t HpsGpio::raw() const {
    const std::uint32_t levels = ~(pins() ^ polarity_);
    return enable_ & ((edge_type_ & captured_) | (~edge_type_ & levels)) & ALL;
}

void HpsGpio::pins_moved(std::uint32_t before, const sc_core::sc_time& now) {
    const std::uint32_t moved = before ^ pins();
    captured_ |= moved & ~(pins() ^ polarity_) & enable_ & edge_type_;
    line_((raw() & ~mask_) != 0);
    if (!moved) return;
    for (const auto& notify : notify_pins_) notify(pins(), now);
}

void HpsGpio::drive(unsigned pin, bool level) {
    const std::uint32_t before = pins();
    outside_ = (outside_ & ~(1u << pin)) | (level ? 1u : 0u) << pin;
    pins_moved(before, sc_core::sc_time_stamp());
}

void HpsGpio::lend(std::uint32_t driven, std::uint32_t levels, const sc_core::sc_time& now) {
    const std::uint32_t before = pins();
    const bool was_lit = led();
    lent_ = driven & ALL;
    lent_levels_ = levels;
    pins_moved(before, now);
    if (led() != was_lit) notify_(led(), now);
}

std::uint32_t HpsGpio::read(std::uint32_t offset, const sc_core::sc_time&) {
    switch (offset) {
        case DATA: return data_;
        case DIRECTION: return direction_;
        case ENABLE: return enable_;
        case MASK: return mask_;
        case TYPE: return edge_type_;
        case POLARITY: return polarity_;
        case STATUS: return raw() & ~mask_;
        case RAW: return raw();
        case DEBOUNCE: return debounce_;
        case PINS: return pins();
        case SYNCHRONISE: return synchronise_;
        case VERSION: return VERSION_2_08;
        default: return 0;
    }
}

void HpsGpio::write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) {
    const std::uint32_t before = pins();
    const bool was_lit = led();
    switch (offset) {
        case DATA: data_ = value & ALL; break;
        case DIRECTION: direction_ = value & ALL; break;
        case ENABLE: enable_ = value & ALL; break;
        case MASK: mask_ = value & ALL; break;
        case TYPE: edge_type_ = value & ALL; break;
        case POLARITY: polarity_ = value & ALL; break;
        case DEBOUNCE: debounce_ = value & ALL; break;
        case EOI: captured_ &= ~value; break;
        case SYNCHRONISE: synchronise_ = value & 1; break;
        default: break;
    }
    pins_moved(before, now);
    if (led() != was_lit) notify_(led(), now);
}

}  // namespace sim
