#include "sim/board/usb_gamepad.h"

#include <algorithm>
#include <iterator>

namespace sim {

namespace {

const UsbBytes GAMEPAD_REPORT{
    0x05, 0x01, 0x09, 0x05, 0xA1, 0x01,                                      // a gamepad
    0x15, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08, 0x95, 0x04,                    // X, Y, Z, Rz:
    0x09, 0x30, 0x09, 0x31, 0x09, 0x32, 0x09, 0x35, 0x81, 0x02,              // a byte each
    0x25, 0x07, 0x35, 0x00, 0x46, 0x3B, 0x01, 0x65, 0x14,                    // the d-pad: 0 to 7,
    0x75, 0x04, 0x95, 0x01, 0x09, 0x39, 0x81, 0x42, 0x65, 0x00, 0x81, 0x01,  // 45 degrees each
    0x05, 0x09, 0x19, 0x01, 0x29, 0x0F, 0x25, 0x01, 0x45, 0x01,              // 15 buttons:
    0x75, 0x01, 0x95, 0x0F, 0x81, 0x02, 0x95, 0x01, 0x81, 0x01, 0xC0,        // a bit each
};

}  // namespace

UsbGamepad::UsbGamepad(bool is_plugged)
    : UsbDevice{{UsbPlug::GAMEPAD, "USB Gamepad", 0x0079, 0x0006, 0x0110, 0, 0, GAMEPAD_REPORT,
                 0x0110, 0x0110},
                is_plugged} {
    reset();
}

std::optional<unsigned> UsbGamepad::number_of(PadButton button, UsbPlug plug) {
    using Button = PadButton;
    constexpr auto NONE = Button{-1};
    constexpr Button ALL[] = {
        Button::A,      Button::B,     NONE,         Button::X,          Button::Y,
        NONE,           Button::L,     Button::R,    Button::L2,         Button::R2,
        Button::SELECT, Button::START, Button::HOME, Button::LEFT_STICK, Button::RIGHT_STICK};
    constexpr Button SNES[] = {Button::X, Button::A, Button::B, Button::Y,      Button::L,
                               Button::R, NONE,      NONE,      Button::SELECT, Button::START};
    const auto find = [&](const Button* begin, const Button* end) -> std::optional<unsigned> {
        const Button* const at = std::find(begin, end, button);
        return at == end ? std::nullopt : std::optional{static_cast<unsigned>(at - begin)};
    };
    return plug == UsbPlug::GAMEPAD ? find(std::begin(ALL), std::end(ALL))
                                    : find(std::begin(SNES), std::end(SNES));
}

bool UsbGamepad::is_down(PadButton which) const {
    const auto number = number_of(which, about().plug);
    return number && (buttons_ >> *number & 1);
}

std::array<int, 2> UsbGamepad::pad() const {
    return {is_down(Direction::RIGHT) - is_down(Direction::LEFT),
            is_down(Direction::DOWN) - is_down(Direction::UP)};
}

std::vector<int> UsbGamepad::axes() const {
    std::vector<int> all{sticks_.begin(), sticks_.end()};
    for (const int way : pad()) all.push_back(way);
    return all;
}

UsbBytes UsbGamepad::report(bool) const {
    constexpr std::uint8_t CLOCKWISE[3][3] = {{7, 0, 1}, {6, 8, 2}, {5, 4, 3}};
    UsbBytes bytes;
    for (const int place : sticks_) bytes.push_back(static_cast<std::uint8_t>(place));
    bytes.push_back(CLOCKWISE[pad()[1] + 1][pad()[0] + 1]);
    bytes.push_back(static_cast<std::uint8_t>(buttons_));
    bytes.push_back(static_cast<std::uint8_t>(buttons_ >> 8));
    return bytes;
}

void UsbGamepad::button(PadButton which, bool down) {
    const unsigned number = number_of(which, about().plug).value();
    buttons_ = down ? buttons_ | 1u << number : buttons_ & ~(1u << number);
    if (!is_plugged()) return;
    hear_.button(number, down);
    changed();
}

void UsbGamepad::direction(Direction which, bool down) {
    const unsigned bit = 1u << static_cast<unsigned>(which);
    directions_ = down ? directions_ | bit : directions_ & ~bit;
    if (!is_plugged()) return;
    hear_.axes();
    changed();
}

void UsbGamepad::stick(Stick which, int right, int down) {
    const std::size_t first = which == Stick::LEFT ? 0 : 2;
    const auto place = [](int way) { return MIDDLE + (way < 0 ? way * 128 : way * 127) / REACH; };
    sticks_[first] = place(right);
    sticks_[first + 1] = place(down);
    if (!is_plugged()) return;
    hear_.axes();
    changed();
}

}  // namespace sim
