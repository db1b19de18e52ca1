// input.h - the keyboard, the mouse and gamepads on USB as Linux' input drivers show them.
//
//   /dev/input/event*  struct input_event, numbered from 0 in the order of plugging in, and by
//                      by-id/ and by-path/                      event_file.h
//   /dev/input/mice    packets of the PS/2 protocol; mouse0     mice_file.h
//   /dev/input/js*     gamepads: struct js_event                joystick_file.h
//   /proc/bus/input/devices; /sys/class/input
//
// A device is there while the HID driver has it: from when it is plugged in, until it is unplugged
// or a program takes it by usbfs (usb_bus.h).  An open file of one that has gone returns ENODEV.
//
// Source: Linux 6.1, drivers/hid/hid-input.c, hid-dr.c.
//
// Not handled: the up to 8 ms from a movement to its report: events come at once.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "sim/board/usb_ports.h"
#include "sim/linux/device.h"
#include "sim/linux/input_device.h"
#include "sim/linux/own_files.h"

namespace sim {

class MiceFile;

class LinuxInput {
public:
    // `notify`: a program that has one of them open may go on.
    explicit LinuxInput(std::function<void()> notify) : notify_{std::move(notify)} {}

    // Hears from now on what hands do with those that are bound.
    void attach(UsbPorts& ports);

    // The HID driver takes a device, at a port ("1-1.2"), whose interface has a folder in /sys; or
    // lets go of it.
    void bind(const UsbDevice& device, const std::string& port, const std::string& folder);
    void unbind(const UsbDevice& device);

    // By a path without links; nullptr: it is none of them.
    std::shared_ptr<LinuxDevice> open(const std::string& path);
    void list(OwnFiles& files) const;

private:
    static constexpr unsigned MICE = 63, FIRST_MOUSE = 32;  // minor numbers

    struct Bound {
        const UsbDevice* usb;
        std::shared_ptr<InputDevice> device;
        std::string port;
        unsigned joystick;  // number of js*, of a gamepad
    };
    // Sends events to an input device.
    using Event = std::function<void(InputDevice&)>;

    void send(const UsbDevice& usb, const Event& event);  // if that is bound
    void attach(UsbGamepad& gamepad);
    std::shared_ptr<InputDevice> first_mouse() const;  // or nullptr
    void describe(const Bound& one, unsigned number, OwnFiles& files) const;

    std::function<void()> notify_;
    Agenda* agenda_ = nullptr;
    std::map<unsigned, Bound> bound_;  // by the number of event*
    std::vector<std::weak_ptr<MiceFile>> mice_;
    unsigned next_input_ = 0;
};

}  // namespace sim
