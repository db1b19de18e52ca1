#include "sim/board/remote_control.h"

#include <utility>

#include "sim/board/nec_frame.h"

namespace sim {

using sc_core::sc_time;

namespace {

const sc_time frame_time{108, sc_core::SC_MS};  // from one frame to the next

}  // namespace

RemoteControl::RemoteControl(const sc_core::sc_module_name& name, std::function<void()> moved)
    : sc_module{name}, moved_{std::move(moved)} {
    SC_HAS_PROCESS(RemoteControl);
    SC_THREAD(send);
}

void RemoteControl::press(std::uint8_t button) {
    buttons_.push_back(button);
    pressed_.notify(sc_core::SC_ZERO_TIME);
}

void RemoteControl::send() {
    for (;;) {
        while (buttons_.empty()) wait(pressed_);
        const sc_time next = sc_core::sc_time_stamp() + frame_time;
        frame_ = nec_frame(buttons_.front());
        for (const std::uint32_t ns : frame_) {
            dark_ = !dark_;
            moved_();
            wait(sc_time{static_cast<double>(ns), sc_core::SC_NS});
        }
        dark_ = true;
        moved_();
        buttons_.pop_front();
        wait(next - sc_core::sc_time_stamp());
    }
}

}  // namespace sim
