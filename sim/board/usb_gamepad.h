// usb_gamepad.h - a USB gamepad with a d-pad, two sticks and buttons: a HID.
//
//   byte 0, 1  the left stick: 0 left, 255 right; 0 up, 255 down; 128 in the middle
//   2, 3       the right stick
//   4          the d-pad: 0 up, and on clockwise in steps of 45 degrees to 7; 8 released
//   5, 6       A, B, -, X, Y, -, L, R, L2, R2, Select, Start, Home, LeftStick, RightStick, from
//              bit 0, as Linux numbers buttons from BTN_GAMEPAD on
//
// Not handled: force feedback; triggers that tell how far they are pressed.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "sim/board/usb_device.h"

namespace sim {

enum class PadButton { A, B, X, Y, L, R, L2, R2, SELECT, START, HOME, LEFT_STICK, RIGHT_STICK };

constexpr bool is_gamepad(UsbPlug plug) {
    return plug == UsbPlug::GAMEPAD || plug == UsbPlug::SNES_GAMEPAD;
}

class UsbGamepad : public UsbDevice {
public:
    enum class Stick { LEFT, RIGHT };
    enum class Direction { UP, DOWN, LEFT, RIGHT };  // of the d-pad
    static constexpr int REACH = 100;                // of a stick, each way

    explicit UsbGamepad(bool is_plugged);

    // The number of a button of such a gamepad, from 0 as Linux counts; no value: it has none.
    static std::optional<unsigned> number_of(PadButton button, UsbPlug plug);

    void button(PadButton which, bool down);
    void direction(Direction which, bool down);
    void stick(Stick which, int right, int down);
    bool is_down(PadButton which) const;
    bool is_down(Direction which) const { return directions_ >> static_cast<unsigned>(which) & 1; }

    // What Linux has as axes, in the order of its numbers: the sticks from 0 to 255, the d-pad from
    // -1 to 1.
    virtual std::vector<int> axes() const;

    // Hears of each while the gamepad is plugged in.
    struct Listener {
        std::function<void(unsigned number, bool down)> button = [](unsigned, bool) {};
        std::function<void()> axes = [] {};
    };
    void on_hand(Listener hear) { hear_ = std::move(hear); }

protected:
    UsbGamepad(About about, bool is_plugged) : UsbDevice{std::move(about), is_plugged} {}

    UsbBytes report(bool boot) const override;
    std::array<int, 2> pad() const;  // right, down
    unsigned buttons() const { return buttons_; }

private:
    static constexpr int MIDDLE = 128;

    Listener hear_;
    unsigned buttons_ = 0, directions_ = 0;  // by their numbers
    std::array<int, 4> sticks_{MIDDLE, MIDDLE, MIDDLE, MIDDLE};
};

}  // namespace sim
