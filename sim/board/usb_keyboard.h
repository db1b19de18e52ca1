// usb_keyboard.h - a USB keyboard with 104 keys, of the boot subclass.
//
//   byte 0  Ctrl, Shift, Alt, Win, and the right ones, from bit 0
//   2 - 7   the other keys that are down, by their HID usages in the order in which they went down;
//           01 in each if there are more than six
//
// Source: USB HID Usage Tables 1.12, page 07.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/board/scan_codes.h"
#include "sim/board/usb_device.h"
#include "sim/pins/agenda.h"

namespace sim {

// On page 07, of a key by its scan code (scan_codes.h); 0: it has none.
std::uint8_t hid_usage(std::uint16_t scan_code);

class UsbKeyboard : public UsbDevice {
public:
    UsbKeyboard(Agenda& agenda, bool is_plugged);

    // A key by its scan code: down from now on until release().
    void press(std::uint16_t key) { move(key, true); }
    void release(std::uint16_t key) { move(key, false); }
    // As Ps2Keyboard::type().
    void type(const std::string& text);

    // Hears of each key while the keyboard is plugged in.
    void on_key(std::function<void(std::uint16_t key, bool down)> hear) { hear_ = std::move(hear); }

private:
    UsbBytes report(bool boot) const override;
    void move(std::uint16_t key, bool down);
    void strike();

    std::function<void(std::uint16_t, bool)> hear_ = [](std::uint16_t, bool) {};
    std::vector<std::uint8_t> held_;  // usages
    std::deque<char> typed_;
    std::optional<Stroke> struck_;  // of a character: down now
    PartTimer strike_;
};

}  // namespace sim
