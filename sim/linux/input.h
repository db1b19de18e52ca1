// input.h - the keyboard and the mouse of the person at the board, on USB, as Linux has them.
//
//   /dev/input/event0   the keyboard: struct input_event        steps such as press-key, type-keys
//   /dev/input/event1   the mouse, likewise                     move-mouse, click-mouse and so on
//   /dev/input/mice     the mouse: packets of the PS/2 protocol, with a wheel if the program
//                       asks as a PS/2 driver does (ImPS/2); also mouse0
//
// They are the devices that are on PS/2, too: what hands do reaches both.  Each open file has its
// own queue; what does not fit is lost, as SYN_DROPPED says.
//
// Source: Linux 6.1, include/uapi/linux/input.h, input-event-codes.h; drivers/input/mousedev.c.
//
// Not handled: repetition of a key that is held; LEDs of the keyboard; other devices.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim/linux/device.h"

namespace sim {

class LinuxInput {
public:
    // `notify`: a program that has one of them open may go on.
    LinuxInput(std::function<std::uint64_t()> now_ns, std::function<void()> notify)
        : now_ns_{std::move(now_ns)}, notify_{std::move(notify)} {}

    // By its path; nullptr: it is none of them.
    std::shared_ptr<LinuxDevice> open(const std::string& path);
    static bool has(const std::string& path);

    // Of the keyboard, by its scan code (board/scan_codes.h).
    void key(std::uint16_t code, bool down);
    // Of the mouse: counts; notches towards the hand; buttons left, right, middle.
    void move(int right, int up);
    void turn(int notches);
    void button(unsigned which, bool down);

private:
    class Events;
    class Mice;

    std::function<std::uint64_t()> now_ns_;
    std::function<void()> notify_;
    std::vector<std::weak_ptr<Events>> events_;
    std::vector<std::weak_ptr<Mice>> mice_;

    void queue_event(bool mouse, std::uint16_t type, std::uint16_t code, int value);
    void queue_sync(bool mouse);
};

}  // namespace sim
