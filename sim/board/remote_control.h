// remote_control.h - the board's infrared remote control, and the receiver that it is pointed at.
//
// A button that is pressed sends one frame (nec_frame.h) of 67.5 ms; frames begin at least 108 ms
// apart.  The receiver (IRM-V538) removes the 38 kHz carrier: its output is low while there is
// light.
//
// Not handled: the repeat codes of a button that is held; the receiver's delays; the board's own
// LED, which the receiver would see if it blinked at 38 kHz.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include <systemc>

namespace sim {

class RemoteControl : public sc_core::sc_module {
public:
    // `moved` is called after each change of dark().
    RemoteControl(const sc_core::sc_module_name& name, std::function<void()> moved);

    // Presses the button of this code, after those that were pressed before.
    void press(std::uint8_t button);

    bool dark() const { return dark_; }

private:
    void send();

    std::function<void()> moved_;
    std::deque<std::uint8_t> buttons_;
    sc_core::sc_event pressed_;
    bool dark_ = true;
    // No variable of send(): a run may end within it, and then its variables are not destroyed.
    std::vector<std::uint32_t> frame_;
};

}  // namespace sim
