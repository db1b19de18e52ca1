// usb_device.h - a HID on one of the board's USB host ports: low speed, one interface.
//
//   endpoint 0       answers requests: for the descriptors, and of the HID class
//   endpoint 1 IN    interrupt: holds one report; when the host has taken that, the next is loaded
//                    if something has changed; or it has one always, as it is now
//
// It is in the boot protocol after SET_PROTOCOL 0, and in the report protocol after it was plugged
// in or reset.  A report is loaded when something changes, as after SET_IDLE 0.
//
// Source: Universal Serial Bus Specification 2.0, chapter 9; Device Class Definition for Human
// Interface Devices 1.11, with appendix B for the boot reports.
//
// Not handled: reports that repeat at the idle rate; remote wake-up; halted endpoints.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/board/part.h"

namespace sim {

enum class UsbPlug { KEYBOARD, MOUSE, GAMEPAD, SNES_GAMEPAD };

using UsbBytes = std::vector<std::uint8_t>;

struct UsbSetup {
    std::uint8_t type, request;
    std::uint16_t value, index, length;
};

class UsbDevice : public Part {
public:
    static constexpr unsigned PERIOD_MS = 8;   // between two polls of the endpoint
    static constexpr std::uint8_t PACKET = 8;  // bytes

    struct About {
        UsbPlug plug;
        std::string name;
        std::uint16_t vendor, product, release;
        std::uint8_t subclass, protocol;  // 1, and 1 or 2: boot keyboard or mouse
        UsbBytes report_descriptor;
        std::uint16_t usb = 0x0110, hid = 0x0111;  // versions
        std::uint8_t country = 0, name_index = 1;
        bool reports_always = false;
    };

    const About& about() const { return about_; }
    UsbBytes device_descriptor() const;
    UsbBytes configuration() const;  // with the interface, the HID and the endpoint

    // What it sends back, or takes of `data`; no value: STALL.
    std::optional<UsbBytes> control(const UsbSetup& setup, const UsbBytes& data);

    bool has_report() const { return about_.reports_always || loaded_.has_value(); }
    UsbBytes take_report();  // which has_report()
    void reset();

    // `notify` is called after each.
    void plug(bool in);
    bool is_plugged() const { return is_plugged_; }
    void on_plug(std::function<void()> notify) { plugged_ = std::move(notify); }
    void on_report(std::function<void()> notify) { reported_ = std::move(notify); }

    std::uint8_t lamps() const { return lamps_; }  // of a keyboard: Num, Caps, Scroll Lock
    void set_lamps(std::uint8_t lit) { lamps_ = lit; }

protected:
    UsbDevice(About about, bool is_plugged) : about_{std::move(about)}, is_plugged_{is_plugged} {}

    // As it is now.
    virtual UsbBytes report(bool boot) const = 0;
    // That has been loaded: movements in it are told.
    virtual void told() {}
    // Since the report that was loaded last.
    virtual bool has_news() const { return report(boot_) != last_; }
    void changed();

private:
    std::optional<UsbBytes> descriptor(std::uint8_t type, std::uint8_t index) const;
    UsbBytes hid_descriptor() const;
    void load();

    const About about_;
    std::function<void()> plugged_ = [] {}, reported_ = [] {};
    bool is_plugged_, boot_ = false;
    std::uint8_t lamps_ = 0, idle_ = 0, configured_ = 1;
    std::optional<UsbBytes> loaded_;
    UsbBytes last_;  // that was loaded
};

}  // namespace sim
