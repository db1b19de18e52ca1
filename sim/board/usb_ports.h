// usb_ports.h - what can be plugged into the board's USB host ports
//
// Not handled: that the board has two of them, so that a third device takes a hub.
#pragma once

#include <array>

#include "sim/board/usb_gamepad.h"
#include "sim/board/usb_keyboard.h"
#include "sim/board/usb_mouse.h"
#include "sim/pins/agenda.h"

namespace sim {

// What a scenario has plugged in from the beginning.
struct UsbPlugs {
    bool keyboard = true, mouse = true, gamepad = false;

    bool has(UsbPlug plug) const {
        return plug == UsbPlug::KEYBOARD ? keyboard : plug == UsbPlug::MOUSE ? mouse : gamepad;
    }
    void set(UsbPlug plug, bool in) {
        (plug == UsbPlug::KEYBOARD ? keyboard : plug == UsbPlug::MOUSE ? mouse : gamepad) = in;
    }
};

struct UsbPorts {
    UsbPorts(Agenda& the_agenda, const UsbPlugs& plugs)
        : agenda{the_agenda},
          keyboard{agenda, plugs.keyboard},
          mouse{plugs.mouse},
          gamepad{plugs.gamepad} {}

    std::array<UsbDevice*, 3> all() { return {&keyboard, &mouse, &gamepad}; }

    Agenda& agenda;
    UsbKeyboard keyboard;
    UsbMouse mouse;
    UsbGamepad gamepad;
};

}  // namespace sim
