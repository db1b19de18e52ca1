// remote_control.h - the board's infrared remote control, and the receiver that it is pointed at.
//
// A button that is pressed sends one frame (nec_frame.h) of 67.5 ms; frames begin at least 108 ms
// apart.  The receiver (IRM-V538) removes the 38 kHz carrier: its output is low while there is
// light.
//
// Not handled: the repeat codes of a button that is held; the receiver's delays; the board's own
// LED, which the receiver would see if it blinked at 38 kHz.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include "sim/board/part.h"
#include "sim/pins/agenda.h"

namespace sim {

class RemoteControl : public Part {
public:
    // `moved` is called after each change of dark().
    RemoteControl(Agenda& agenda, std::function<void()> moved);

    // Presses the button of this code, after those that were pressed before.
    void press(std::uint8_t button);

    bool dark() const { return dark_; }

private:
    void send();

    Agenda& agenda_;
    std::function<void()> moved_;
    std::deque<std::uint8_t> buttons_;
    PartTimer next_{agenda_, [this] { send(); }};
    bool dark_ = true;
    std::vector<std::uint32_t> frame_;  // times in ns, and how many of them have begun
    std::size_t begun_ = 0;
    std::uint64_t next_frame_ps_ = 0;
};

}  // namespace sim
