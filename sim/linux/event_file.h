// event_file.h - an open /dev/input/event*: struct input_event by read(), requests by ioctl().
//
// It keeps 64 events; where more come, the latest and SYN_DROPPED before it stay.  All clocks that
// EVIOCSCLOCKID can choose are the same.
//
// Source: Linux 6.1, drivers/input/evdev.c.
//
// Not handled: EVIOCREVOKE, masks of events, other keycodes, EVIOCSABS.
#pragma once

#include <deque>
#include <memory>
#include <string>

#include "sim/linux/device.h"
#include "sim/linux/input_device.h"

namespace sim {

class EventFile final : public LinuxDevice,
                        public InputListener,
                        public std::enable_shared_from_this<EventFile> {
public:
    EventFile(std::shared_ptr<InputDevice> device, unsigned number)
        : device_{std::move(device)}, number_{number} {}

    FileStatus status() const override;
    std::string name() const override { return "the " + device_->about().name; }
    unsigned can_do() const override;
    std::uint64_t arrivals() const override { return arrivals_; }
    std::int64_t read(void* data, std::size_t bytes) override;
    std::int64_t write(const void* data, std::size_t bytes) override;
    std::int64_t control(std::uint32_t request, std::uint32_t at, AddressSpace& memory) override;
    void hear(const InputEvent& event) override;

private:
    std::int64_t give(std::uint32_t at, std::uint32_t room, const std::vector<std::uint8_t>& bytes,
                      AddressSpace& memory) const;
    std::int64_t set(std::uint32_t what, std::uint32_t at, AddressSpace& memory);
    void forget(std::uint16_t type);

    const std::shared_ptr<InputDevice> device_;
    const unsigned number_;
    std::deque<InputEvent> queue_;
    std::uint64_t arrivals_ = 0;
};

}  // namespace sim
