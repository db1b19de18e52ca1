// usb_ports.h - what can be plugged into the board's USB host ports
//
// Gamepads have a number: 1 and 2 in the order in which they are listed, and one that is plugged in
// later has the lowest that is free.
//
// Not handled: that the board has two of them, so that a third device takes a hub.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sim/board/part.h"
#include "sim/board/usb_gamepad.h"
#include "sim/board/usb_keyboard.h"
#include "sim/board/usb_mouse.h"
#include "sim/board/usb_snes_gamepad.h"
#include "sim/pins/agenda.h"

namespace sim {

// A device by its kind and, of a gamepad, its number; of others that is 0.
struct UsbPlugged {
    UsbPlug plug;
    unsigned number = 0;

    bool operator==(const UsbPlugged& other) const {
        return plug == other.plug && number == other.number;
    }
};

// What is plugged in, in that order.
struct UsbPlugs {
    static constexpr unsigned GAMEPADS = 2;  // at most

    std::vector<UsbPlugged> all{{UsbPlug::KEYBOARD}, {UsbPlug::MOUSE}};

    bool has(UsbPlug plug) const { return !of(plug).empty(); }
    // Those of this number; without one all.
    std::vector<UsbPlugged> of(UsbPlug plug, std::optional<unsigned> number = {}) const;
    std::vector<UsbPlugged> gamepads(std::optional<unsigned> number = {}) const;
    unsigned free_number() const;  // 0: there is none
    void plug(const UsbPlugged& one) { all.push_back(one); }
    void unplug(const UsbPlugged& one);

private:
    template <class Kind>
    std::vector<UsbPlugged> those(std::optional<unsigned> number, Kind is_meant) const;
};

class UsbPorts : public Part {
public:
    UsbPorts(Agenda& the_agenda, const UsbPlugs& plugs);

    // First those that were plugged in at first, in their order.
    const std::vector<UsbDevice*>& all() const { return all_; }
    UsbPlugs plugged() const;
    UsbDevice& device(const UsbPlugged& one);
    UsbGamepad& gamepad(const UsbPlugged& one) { return static_cast<UsbGamepad&>(device(one)); }

    Agenda& agenda;
    UsbKeyboard keyboard;
    UsbMouse mouse;
    std::array<UsbGamepad, UsbPlugs::GAMEPADS> gamepads;
    std::array<UsbSnesGamepad, UsbPlugs::GAMEPADS> snes_gamepads;

private:
    std::vector<UsbDevice*> all_;
};

}  // namespace sim
