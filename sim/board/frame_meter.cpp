#include "sim/board/frame_meter.h"

#include <cmath>

#include "sim/pins/pins.h"

namespace sim {

bool VideoSignal::similar_to(const VideoSignal& other) const {
    const auto near = [](double a, double b, double most) { return std::abs(a - b) <= most; };
    return lines && other.lines && near(lines, other.lines, 0.01 * other.lines) &&
           near(line_samples, other.line_samples, 0.001 * other.line_samples) &&
           hs_positive == other.hs_positive && vs_positive == other.vs_positive &&
           near(shown_samples, other.shown_samples, 1) && near(shown_lines, other.shown_lines, 1);
}

FrameMeter::Begins FrameMeter::run(std::uint32_t control, unsigned count) {
    const bool hs =
        hs_.run(control & video::HS, count) && static_cast<double>(since_line_) >= earliest_;
    const std::uint64_t line = since_line_;
    if (hs) {
        end_line(line);
        since_line_ = 0;
    }
    bool frame = hs && vs_waits_;
    if (vs_.run(control & video::VS, count)) {
        vs_waits_ = !hs && 2 * since_line_ > length_.value();
        frame = !vs_waits_;
    }
    if (frame) {
        vs_waits_ = false;
        end_frame();
    }
    samples_ += count;
    since_line_ += count;
    if (control & video::BLANK_N) {
        was_high_ = true;
        shown_samples_ += count;
    } else {
        was_low_ = true;
    }
    return {hs, frame};
}

void FrameMeter::end_line(std::uint64_t samples) {
    ++lines_;
    length_.vote(static_cast<unsigned>(samples));
    if (shown_samples_) {
        ++shown_lines_;
        shown_.vote(shown_samples_);
        shown_samples_ = 0;
    }
}

void FrameMeter::end_frame() {
    signal_ = {};
    if (in_frame_ && lines_) {
        const bool even = 16 * length_.votes() >= 15 * static_cast<int>(lines_);
        signal_ = {lines_,
                   static_cast<double>(samples_) / lines_,
                   even ? length_.value() : 0,
                   hs_.positive(),
                   vs_.positive(),
                   !was_low_    ? VideoSignal::Blank::NEVER_LOW
                   : !was_high_ ? VideoSignal::Blank::NEVER_HIGH
                                : VideoSignal::Blank::MOVES,
                   shown_.value(),
                   shown_lines_};
    }
    in_frame_ = true;
    samples_ = 0;
    lines_ = shown_lines_ = 0;
    was_low_ = was_high_ = false;
    length_ = shown_ = {};
}

}  // namespace sim
