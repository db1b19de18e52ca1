// joystick_file.h - an open /dev/input/js*: struct js_event by read(), the joystick interface.
//
// First come all buttons and axes as they are, with JS_EVENT_INIT, then what changes.  Axes are
// stretched to -32767 to 32767, with 0 within the flat part in the middle.  It keeps 64 events;
// where more come, it begins again with all.
//
// Source: Linux 6.1, drivers/input/joydev.c; include/uapi/linux/joystick.h.
//
// Not handled: the reads of version 0.x; JSIOCSCORR, JSIOCSAXMAP, JSIOCSBTNMAP.
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "sim/linux/device.h"
#include "sim/linux/input_device.h"

namespace sim {

class JoystickFile final : public LinuxDevice, public InputListener {
public:
    JoystickFile(std::shared_ptr<InputDevice> device, unsigned number);

    FileStatus status() const override;
    std::string name() const override { return "the " + device_->about().name; }
    unsigned can_do() const override;
    std::uint64_t arrivals() const override { return arrivals_; }
    std::int64_t read(void* data, std::size_t bytes) override;
    std::int64_t control(std::uint32_t request, std::uint32_t at, AddressSpace& memory) override;
    void hear(const InputEvent& event) override;

private:
    struct Event {  // struct js_event
        std::uint32_t ms;
        std::int16_t value;
        std::uint8_t type, number;
    };

    void begin(std::uint32_t ms);
    std::int16_t stretched(std::uint16_t axis, std::int32_t value) const;

    const std::shared_ptr<InputDevice> device_;
    const unsigned number_;
    std::vector<std::uint16_t> buttons_;  // codes, by number
    std::vector<std::uint8_t> axes_;
    std::vector<std::int16_t> places_;  // of the axes
    std::deque<Event> queue_;
    std::uint64_t arrivals_ = 1;
};

}  // namespace sim
