// input_device.h - what Linux's input core keeps of a keyboard, mouse or gamepad, and who hears it.
//
// Events that change nothing are dropped: a key that is down already, a movement by 0, an axis that
// is there.  A key that is held repeats, value 2, from 250 ms on every 33 ms, if the device has
// EV_REP.  Who grabs a device hears it alone.
//
// Source: Linux 6.1, drivers/input/input.c; include/uapi/linux/input-event-codes.h.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "sim/pins/agenda.h"

namespace sim {

namespace input_event {

constexpr std::uint32_t MAJOR = 13;  // of the nodes below /dev/input

constexpr std::uint16_t SYN = 0, KEY = 1, REL = 2, ABS = 3, MSC = 4, SW = 5, LED = 0x11, SND = 0x12,
                        REP = 0x14, FF = 0x15;
constexpr std::uint16_t SYN_REPORT = 0, SYN_DROPPED = 3, MSC_SCAN = 4;
constexpr std::uint16_t REL_X = 0, REL_Y = 1, REL_WHEEL = 8, REL_WHEEL_HI_RES = 11;
constexpr std::uint16_t ABS_X = 0, ABS_Y = 1, ABS_Z = 2, ABS_RZ = 5, ABS_HAT0X = 0x10,
                        ABS_HAT0Y = 0x11;
constexpr std::uint16_t BTN_LEFT = 0x110, BTN_JOYSTICK = 0x120, BTN_GAMEPAD = 0x130;

}  // namespace input_event

// struct input_event
struct InputEvent {
    std::uint32_t s, us;
    std::uint16_t type, code;
    std::int32_t value;
};
static_assert(sizeof(InputEvent) == 16);

class InputListener {
public:
    virtual ~InputListener() = default;
    virtual void hear(const InputEvent& event) = 0;
};

class InputDevice {
public:
    struct About {
        std::string name, place;  // EVIOCGNAME, EVIOCGPHYS
        std::string folder;       // in /sys
        std::uint16_t vendor, product, version;
    };
    struct Axis {  // struct input_absinfo
        std::int32_t value, least, most, fuzz, flat, resolution;
    };

    InputDevice(About about, Agenda& agenda, std::function<void()> notify);

    // What it can do, before it is used.
    void can(std::uint16_t type, std::initializer_list<std::uint16_t> codes);
    void has_axis(std::uint16_t code, const Axis& axis);

    void add(const std::weak_ptr<InputListener>& listener) { listeners_.push_back(listener); }
    void event(std::uint16_t type, std::uint16_t code, int value);
    void report() { event(input_event::SYN, input_event::SYN_REPORT, 0); }
    // It has been unplugged, or its driver has let go of it.
    void disconnect();
    bool exists() const { return exists_; }

    const About& about() const { return about_; }
    std::uint64_t now_ns() const { return agenda_.now_ps() / 1000; }
    bool has(std::uint16_t type) const { return codes_.count(type) > 0; }
    bool has(std::uint16_t type, std::uint16_t code) const;
    // Bit n for code n; `is_state`: of those that are on.
    std::vector<std::uint8_t> bits(std::uint16_t type, bool is_state = false) const;
    const std::map<std::uint16_t, Axis>& axes() const { return axes_; }
    std::array<std::uint32_t, 2> repetition{250, 33};  // delay and period in ms

    // 0, or EBUSY or EINVAL.
    int grab(const std::shared_ptr<InputListener>& listener, bool on);

    // Codes of each type, and those in use: a bit each; 0: there is no such type.
    static unsigned codes_of(std::uint16_t type);

private:
    bool changes(std::uint16_t type, std::uint16_t code, int value);
    void pass(std::uint16_t type, std::uint16_t code, int value);
    void repeat();

    const About about_;
    Agenda& agenda_;
    const std::function<void()> notify_;
    std::map<std::uint16_t, std::vector<std::uint8_t>> codes_, on_;
    std::map<std::uint16_t, Axis> axes_;
    std::vector<std::weak_ptr<InputListener>> listeners_;
    std::weak_ptr<InputListener> grabbed_;
    std::uint16_t repeating_ = 0;
    PartTimer repeat_;
    bool exists_ = true;
};

}  // namespace sim
