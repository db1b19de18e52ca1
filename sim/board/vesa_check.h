// vesa_check.h - checks the VGA pins against VESA DMT 640 x 480 at 60 Hz to the clock
//
//                      total   sync width   sync begin to picture   picture   polarity
//   clocks of a line     800           96                     144       640   negative
//   lines of a frame     525            2                      35       480   negative
//
// A line begins where HS falls, a frame where VS does.  What differs from the table, and colour
// while BLANK_N is low, is a violation with frame, line and clock.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sim {

class VesaCheck {
public:
    // The pins at each clock, in runs in which HS, VS and BLANK_N are `control`.
    void run(std::uint32_t control, const std::uint32_t* pins, unsigned count);

    std::uint64_t violations() const { return violations_; }
    // The first 20, a line each: "frame 3, line 12, clock 656: HS low for 95 clocks, expected 96".
    const std::vector<std::string>& messages() const { return messages_; }

private:
    void begin_line();
    void end_line();
    void begin_frame();
    void colour_in_blanking(const std::uint32_t* pins, unsigned count);
    void check(const char* what, std::uint64_t got, std::uint64_t expected, const char* unit);
    void violation(const std::string& what);

    std::uint32_t control_ = ~0u;  // HS, VS, BLANK_N of the sample before; ~0: none yet
    std::uint64_t clock_ = 0;      // of this line, 0 where HS began
    std::uint64_t line_ = 0;       // of this frame, 0 where VS began
    bool in_step_ = false;         // a whole frame may be expected: VS has begun once
    bool line_known_ = false;      // HS has begun once
    std::uint64_t hs_low_ = 0, vs_low_ = 0;
    std::uint64_t row_begin_ = 0;   // clock at which this line's picture began
    std::uint64_t row_pixels_ = 0;  // pixels of this line so far
    std::uint64_t first_row_line_ = 0;
    unsigned rows_ = 0;             // rows of this frame so far
    bool colour_reported_ = false;  // one violation a line for colour in the blanking

    std::uint64_t frames_ = 0, violations_ = 0;
    std::vector<std::string> messages_;
};

}  // namespace sim
