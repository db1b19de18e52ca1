#include "sim/board/vesa_check.h"

#include <fmt/format.h>

#include "sim/pins/pins.h"

namespace sim {

namespace {

constexpr unsigned LINE_CLOCKS = 800, HS_CLOCKS = 96, PICTURE_CLOCK = 144, WIDTH = 640;
constexpr unsigned FRAME_LINES = 525, VS_LINES = 2, PICTURE_LINE = 35, HEIGHT = 480;
constexpr std::size_t VIDEO_MESSAGES = 20;

}  // namespace

void VesaCheck::run(std::uint32_t control, const std::uint32_t* pins, unsigned count) {
    const bool first = control_ == ~0u;
    const std::uint32_t fell = first ? 0 : control_ & ~control,
                        rose = first ? 0 : ~control_ & control;
    if (rose & video::HS && line_known_) check("HS low", hs_low_, HS_CLOCKS, "clocks");
    if (rose & video::VS && in_step_) check("VS low", vs_low_, VS_LINES * LINE_CLOCKS, "clocks");
    // VS may begin with HS or in the middle of a line, which then counts as the frame's first.
    if (fell & video::HS) {
        if (line_known_) end_line();
        begin_line();
    }
    if (fell & video::VS) begin_frame();
    control_ = control;

    if (!(control & video::HS)) hs_low_ += count;
    if (!(control & video::VS)) vs_low_ += count;
    if (control & video::BLANK_N) {
        if (row_pixels_ == 0) row_begin_ = clock_;
        row_pixels_ += count;
    } else if (!colour_reported_) {
        colour_in_blanking(pins, count);
    }
    clock_ += count;
}

void VesaCheck::colour_in_blanking(const std::uint32_t* pins, unsigned count) {
    std::uint32_t colour = 0;
    for (unsigned i = 0; i < count; ++i) colour |= pins[i] & video::RGB;
    if (!colour) return;
    unsigned at = 0;
    while (!(pins[at] & video::RGB)) ++at;
    clock_ += at;
    violation(fmt::format("colour 0x{:06X} during blanking", pins[at] & video::RGB));
    clock_ -= at;
    colour_reported_ = true;
}

void VesaCheck::begin_line() {
    line_known_ = true;
    clock_ = hs_low_ = 0;
    row_pixels_ = 0;
    colour_reported_ = false;
}

void VesaCheck::end_line() {
    check("line", clock_, LINE_CLOCKS, "clocks");
    if (row_pixels_) {
        check("picture begins after", row_begin_, PICTURE_CLOCK, "clocks from HS");
        check("picture row", row_pixels_, WIDTH, "clocks");
        if (rows_ == 0) first_row_line_ = line_;
        ++rows_;
    }
    ++line_;
}

void VesaCheck::begin_frame() {
    if (in_step_) {
        check("frame", line_, FRAME_LINES, "lines");
        check("picture begins after", first_row_line_, PICTURE_LINE, "lines from VS");
        check("picture", rows_, HEIGHT, "rows");
        frames_ += rows_ > 0;
    }
    in_step_ = line_known_;
    line_ = 0;
    vs_low_ = 0;
    rows_ = 0;
}

void VesaCheck::check(const char* what, std::uint64_t got, std::uint64_t expected,
                      const char* unit) {
    if (got != expected) violation(fmt::format("{} {} {}, expected {}", what, got, unit, expected));
}

void VesaCheck::violation(const std::string& what) {
    ++violations_;
    if (messages_.size() < VIDEO_MESSAGES)
        messages_.push_back(
            fmt::format("frame {}, line {}, clock {}: {}", frames_ + 1, line_, clock_, what));
}

}  // namespace sim
