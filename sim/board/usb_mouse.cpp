#include "sim/board/usb_mouse.h"

#include <algorithm>

namespace sim {

namespace {

const UsbBytes MOUSE_REPORT{
    0x05, 0x01, 0x09, 0x02, 0xA1, 0x01, 0x09, 0x01, 0xA1, 0x00,  // a mouse, which is a pointer
    0x05, 0x09, 0x19, 0x01, 0x29, 0x03, 0x15, 0x00, 0x25, 0x01,  // three buttons: a bit each
    0x95, 0x03, 0x75, 0x01, 0x81, 0x02, 0x95, 0x01, 0x75, 0x05, 0x81, 0x01,  // and 5 unused bits
    0x05, 0x01, 0x09, 0x30, 0x09, 0x31, 0x09, 0x38, 0x15, 0x81, 0x25, 0x7F,  // X, Y, wheel:
    0x75, 0x08, 0x95, 0x03, 0x81, 0x06, 0xC0, 0xC0,                          // differences
};

int in_a_report(int way) { return std::clamp(way, -127, 127); }

}  // namespace

UsbMouse::UsbMouse(bool is_plugged)
    : UsbDevice{{UsbPlug::MOUSE, "USB Optical Mouse", 0x046D, 0x0001, 0x0111, 1, 2, MOUSE_REPORT},
                is_plugged} {
    reset();
}

UsbBytes UsbMouse::report(bool boot) const {
    UsbBytes bytes{buttons_, static_cast<std::uint8_t>(in_a_report(right_)),
                   static_cast<std::uint8_t>(in_a_report(down_))};
    if (!boot) bytes.push_back(static_cast<std::uint8_t>(in_a_report(away_)));
    return bytes;
}

void UsbMouse::told() {
    right_ -= in_a_report(right_), down_ -= in_a_report(down_), away_ -= in_a_report(away_);
    told_buttons_ = buttons_;
}

bool UsbMouse::has_news() const {
    return right_ != 0 || down_ != 0 || away_ != 0 || buttons_ != told_buttons_;
}

void UsbMouse::move(int right, int up) {
    if (!is_plugged()) return;
    hear_.move(right, up);
    right_ += right, down_ -= up;
    changed();
}

void UsbMouse::turn(int notches) {
    if (!is_plugged()) return;
    hear_.turn(notches);
    away_ -= notches;
    changed();
}

void UsbMouse::button(MouseButton which, bool down) {
    const unsigned bit = 1u << static_cast<unsigned>(which);
    buttons_ = static_cast<std::uint8_t>(down ? buttons_ | bit : buttons_ & ~bit);
    if (!is_plugged()) return;
    hear_.button(which, down);
    changed();
}

}  // namespace sim
