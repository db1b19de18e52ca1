// monitor.h - a VGA monitor: finds the picture in HS, VS, BLANK and the colours, and checks timing.
//
// It knows the standard (VESA DMT 640 x 480 at 60 Hz) and the ADV7123's pins, nothing else:
//
//                      total   sync width   sync begin to picture   picture   polarity
//   clocks of a line     800           96                     144       640   negative
//   lines of a frame     525            2                      35       480   negative
//
// A line begins where HS begins, a frame where VS begins; the last picture row of a frame and all
// before it are then whole, and the picture is given to the sink.  What differs from the table, and
// colour while BLANK is active, is a violation with frame, line and clock.
//
// Not handled: other video modes (each frame of one is a violation), sync on green.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace sim {

class Monitor {
public:
    static constexpr unsigned WIDTH = 640, HEIGHT = 480;

    struct Frame {
        std::uint64_t number;                      // 1 is the first one since power-on
        bool is_new;                               // its picture differs from the frame before
        const std::vector<std::uint32_t>& pixels;  // 0x00RRGGBB, row by row
    };
    using Sink = std::function<void(const Frame&)>;

    explicit Monitor(Sink sink) : sink_{std::move(sink)} {}

    // The pins at each rising edge of VGA_CLK, in order (bits: sim/fpga/fabric.h, video).
    void samples(const std::uint32_t* pins, std::size_t count);

    std::uint64_t frames() const { return frames_; }
    std::uint64_t new_pictures() const { return new_pictures_; }

    std::uint64_t violations() const { return violations_; }
    // The first 20, a line each: "frame 3, line 12, clock 656: HS low for 95 clocks, expected 96".
    const std::vector<std::string>& messages() const { return messages_; }

private:
    void run_of(std::uint32_t control, const std::uint32_t* pins, unsigned count);
    void begin_line();
    void end_line();
    void begin_frame();
    void check(const char* what, std::uint64_t got, std::uint64_t expected, const char* unit);
    void violation(const std::string& what);

    Sink sink_;

    std::uint32_t control_ = ~0u;  // HS, VS, BLANK_N of the sample before; ~0: none yet
    std::uint64_t clock_ = 0;      // of this line, 0 where HS began
    std::uint64_t line_ = 0;       // of this frame, 0 where VS began
    bool in_step_ = false;         // a whole frame may be expected: VS has begun once
    bool line_known_ = false;      // HS has begun once
    std::uint64_t hs_low_ = 0, vs_low_ = 0;
    std::uint64_t row_begin_ = 0;  // clock at which this line's picture began
    unsigned row_pixels_ = 0;      // pixels of this line so far
    std::uint64_t first_row_line_ = 0;
    unsigned rows_ = 0;         // rows of this frame so far
    bool colour_told_ = false;  // one violation a line for colour in the blanking

    bool is_new_ = false;
    std::vector<std::uint32_t> pixels_ = std::vector<std::uint32_t>(WIDTH * HEIGHT);
    std::vector<std::uint32_t> row_ = std::vector<std::uint32_t>(WIDTH);

    std::uint64_t frames_ = 0, new_pictures_ = 0, violations_ = 0;
    std::vector<std::string> messages_;
};

}  // namespace sim
