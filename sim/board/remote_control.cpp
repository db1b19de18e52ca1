#include "sim/board/remote_control.h"

#include <utility>

#include "sim/board/nec_frame.h"

namespace sim {

namespace {

constexpr std::uint64_t FRAME_PS = 108'000'000'000;  // from one frame to the next: 108 ms
constexpr std::uint64_t PS_PER_NS = 1000;

}  // namespace

RemoteControl::RemoteControl(Agenda& agenda, std::function<void()> moved)
    : agenda_{agenda}, moved_{std::move(moved)} {}

void RemoteControl::press(std::uint8_t button) {
    buttons_.push_back(button);
    if (!next_.is_set()) next_.set_in(0);
}

// The next light or pause of the frame, or the next frame.
void RemoteControl::send() {
    if (frame_.empty()) {
        if (buttons_.empty()) return;
        frame_ = nec_frame(buttons_.front());
        buttons_.pop_front();
        begun_ = 0;
        next_frame_ps_ = agenda_.now_ps() + FRAME_PS;
    }
    if (begun_ < frame_.size()) {
        dark_ = !dark_;
        next_.set_in(frame_[begun_++] * PS_PER_NS);
    } else {
        dark_ = true;
        frame_.clear();
        next_.set(next_frame_ps_);
    }
    moved_();
}

}  // namespace sim
