// ps2_keyboard.h - a PS/2 keyboard with 104 keys and scan code set 2.
//
// After its self-test it sends AA.  A key sends its make code when it goes down and its break code
// when it comes up (scan_codes.h).  The last key that went down repeats while it is held: after
// 500 ms 10.9 times per second, or as command F3 says, and only if nothing else waits to be sent.
// Keys moved during the self-test are processed after it.
//
//   FF reset (FA; after the test AA)      F4 on, F5 off: keys send nothing (FA)
//   FE the last byte again                F6 defaults (FA)
//   EE echo (EE)                          F2 identity (FA AB 83)
//   ED lamps, F3 repeat, F0 code set: FA, and FA again for the argument; F0 00 is answered FA 02
//
// Any other byte is answered with FE.  Between a command and its argument, keys wait.
//
// Not handled: other code sets than 2 (FE); the shifts that a keyboard puts around its cursor keys
// while Shift is held or the Num Lock lamp is lit; Ctrl with Pause and Alt with PrintScreen.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "sim/board/ps2_device.h"
#include "sim/board/scan_codes.h"

namespace sim {

class Ps2Keyboard : public Ps2Device {
public:
    Ps2Keyboard(Agenda& agenda, std::function<void()> moved);

    // A key by its code (scan_codes.h): down from now on until release().
    void press(std::uint16_t key);
    void release(std::uint16_t key);

    // Strikes the keys of characters that have a stroke(), one after the other, each down for 20 ms
    // and up for 20 ms, from now on.
    void type(const std::string& text);

    // Also hears of each key, when a finger moves it: the same keyboard on USB.
    void set_listener(std::function<void(std::uint16_t key, bool down)> listener) {
        listener_ = std::move(listener);
    }

    bool enabled() const { return enabled_; }
    std::uint8_t lamps() const { return lamps_; }  // as of command ED

private:
    enum Command : std::uint8_t;  // beside those of every device

    struct Move {
        std::uint16_t key;
        bool down;
    };

    void start() override;
    void command(std::uint8_t byte) override;
    bool may_report() const override { return argument_of_ == 0; }
    bool argument(std::uint8_t of, std::uint8_t byte);
    void defaults();
    void set_rate(std::uint8_t byte);
    void scan();
    void strike();
    void repeat();

    std::function<void(std::uint16_t, bool)> listener_ = [](std::uint16_t, bool) {};
    std::deque<Move> moves_;  // that the keyboard has not processed yet
    std::deque<char> typed_;
    std::optional<Stroke> struck_;  // of a character: down now
    PartTimer strike_{agenda_, [this] { strike(); }};
    std::uint16_t repeating_ = 0;  // 0: none
    PartTimer repeat_{agenda_, [this] { repeat(); }};
    std::uint64_t delay_ps_ = 0, period_ps_ = 0;  // of the repetition
    std::uint8_t argument_of_ = 0, lamps_ = 0;
    bool enabled_ = false;
};

}  // namespace sim
