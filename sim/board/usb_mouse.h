// usb_mouse.h - a USB mouse with three buttons and a wheel, of the boot subclass.
//
//   byte 0  left, right, middle, from bit 0
//   1, 2    X to the right, Y down: -127 to 127; the rest comes in the next report
//   3       the wheel, away from the hand; not in the boot protocol
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "sim/board/ps2_ports.h"
#include "sim/board/usb_device.h"

namespace sim {

class UsbMouse : public UsbDevice {
public:
    explicit UsbMouse(bool is_plugged);

    // As Ps2Mouse.
    void move(int right, int up);
    void turn(int notches);
    void button(MouseButton which, bool down);

    // Hears of these while the mouse is plugged in.
    struct Listener {
        std::function<void(int right, int up)> move = [](int, int) {};
        std::function<void(int notches)> turn = [](int) {};
        std::function<void(MouseButton, bool down)> button = [](MouseButton, bool) {};
    };
    void on_hand(Listener hear) { hear_ = std::move(hear); }

private:
    UsbBytes report(bool boot) const override;
    void told() override;
    bool has_news() const override;

    Listener hear_;
    int right_ = 0, down_ = 0, away_ = 0;  // since the last report
    std::uint8_t buttons_ = 0, told_buttons_ = 0;
};

}  // namespace sim
