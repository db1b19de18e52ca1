#include "sim/board/monitor.h"

#include <algorithm>

#include <fmt/format.h>

#include "sim/fpga/fabric.h"

namespace sim {

namespace {

constexpr std::uint32_t CONTROL = video::HS | video::VS | video::BLANK_N;
constexpr unsigned LINE_CLOCKS = 800, HS_CLOCKS = 96, PICTURE_CLOCK = 144;
constexpr unsigned FRAME_LINES = 525, VS_LINES = 2, PICTURE_LINE = 35;
constexpr std::size_t MESSAGES = 20;

}  // namespace

// The pins' levels last for many clocks: work on runs of equal control levels.
void Monitor::samples(const std::uint32_t* pins, std::size_t count) {
    for (std::size_t i = 0; i < count;) {
        const std::uint32_t control = pins[i] & CONTROL;
        std::size_t end = i + 1;
        while (end < count && (pins[end] & CONTROL) == control) ++end;
        run_of(control, pins + i, static_cast<unsigned>(end - i));
        i = end;
    }
}

void Monitor::run_of(std::uint32_t control, const std::uint32_t* pins, unsigned count) {
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
        for (unsigned i = 0; i < count && row_pixels_ + i < WIDTH; ++i)
            row_[row_pixels_ + i] = pins[i] & video::RGB;
        row_pixels_ += count;
    } else if (!colour_told_) {
        std::uint32_t colour = 0;
        for (unsigned i = 0; i < count; ++i) colour |= pins[i] & video::RGB;
        if (colour) {
            unsigned at = 0;
            while (!(pins[at] & video::RGB)) ++at;
            clock_ += at;
            violation(fmt::format("colour 0x{:06X} during blanking", pins[at] & video::RGB));
            clock_ -= at;
            colour_told_ = true;
        }
    }
    clock_ += count;
}

void Monitor::begin_line() {
    line_known_ = true;
    clock_ = hs_low_ = 0;
    row_pixels_ = 0;
    colour_told_ = false;
}

void Monitor::end_line() {
    check("line", clock_, LINE_CLOCKS, "clocks");
    if (row_pixels_) {
        check("picture begins after", row_begin_, PICTURE_CLOCK, "clocks from HS");
        check("picture row", row_pixels_, WIDTH, "clocks");
        if (rows_ == 0) first_row_line_ = line_;
        if (rows_ < HEIGHT) {
            std::fill(row_.begin() + std::min(row_pixels_, WIDTH), row_.end(), 0u);
            const auto row = pixels_.begin() + rows_ * WIDTH;
            if (!std::equal(row_.begin(), row_.end(), row)) {
                std::copy(row_.begin(), row_.end(), row);
                is_new_ = true;
            }
        }
        ++rows_;
    }
    ++line_;
}

void Monitor::begin_frame() {
    if (in_step_) {
        check("frame", line_, FRAME_LINES, "lines");
        check("picture begins after", first_row_line_, PICTURE_LINE, "lines from VS");
        check("picture", rows_, HEIGHT, "rows");
    }
    if (in_step_ && rows_ > 0) {
        if (rows_ < HEIGHT) std::fill(pixels_.begin() + rows_ * WIDTH, pixels_.end(), 0u);
        ++frames_;
        const bool is_new = is_new_ || frames_ == 1;
        new_pictures_ += is_new;
        if (sink_) sink_({frames_, is_new, pixels_});
    }
    in_step_ = line_known_;
    line_ = 0;
    vs_low_ = 0;
    rows_ = 0;
    is_new_ = false;
}

void Monitor::check(const char* what, std::uint64_t got, std::uint64_t expected, const char* unit) {
    if (got != expected) violation(fmt::format("{} {} {}, expected {}", what, got, unit, expected));
}

void Monitor::violation(const std::string& what) {
    ++violations_;
    if (messages_.size() < MESSAGES)
        messages_.push_back(
            fmt::format("frame {}, line {}, clock {}: {}", frames_ + 1, line_, clock_, what));
}

}  // namespace sim
