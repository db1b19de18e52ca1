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
#include <utility>

#include "sim/board/usb_device.h"

namespace sim {

class UsbGamepad : public UsbDevice {
public:
    enum class Stick { LEFT, RIGHT };
    enum class Direction { UP, DOWN, LEFT, RIGHT };  // of the d-pad
    static constexpr unsigned BUTTONS = 15;
    static constexpr int REACH = 100;  // of a stick, each way

    explicit UsbGamepad(bool is_plugged);

    void button(unsigned number, bool down);  // by its bit
    void direction(Direction which, bool down);
    void stick(Stick which, int right, int down);

    // What Linux has as axes: the sticks from 0 to 255, the d-pad from -1 to 1.
    std::array<int, 4> sticks() const { return sticks_; }
    std::array<int, 2> pad() const;  // right, down

    // Hears of each while the gamepad is plugged in.
    struct Listener {
        std::function<void(unsigned number, bool down)> button = [](unsigned, bool) {};
        std::function<void()> axes = [] {};
    };
    void on_hand(Listener hear) { hear_ = std::move(hear); }

private:
    static constexpr int MIDDLE = 128;

    UsbBytes report(bool boot) const override;

    Listener hear_;
    unsigned buttons_ = 0, directions_ = 0;
    std::array<int, 4> sticks_{MIDDLE, MIDDLE, MIDDLE, MIDDLE};
};

}  // namespace sim
