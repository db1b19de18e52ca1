// raster.h - puts a frame's picture together, line by line, where a Placement says that it is
//
// What of the picture the signal does not have is black, what it has more is cut.  A pixel is the
// sample that is nearest to its middle.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "sim/board/line_phase.h"
#include "sim/board/picture_lock.h"

namespace sim {

class Raster {
public:
    explicit Raster(const Placement& place);

    // Samples of the colours, while BLANK_N is high or low.  Where a line or a frame begins with
    // the first of them, which is reported before, the line first.
    void run(const std::uint32_t* pins, unsigned count, bool blank_n);
    void begin_line();
    // Completes the picture.  False: there is none, since nobody saw the frame begin, or it had no
    // row.  begin_frame() has to follow.
    bool end_frame();
    void begin_frame();

    // Valid from end_frame() to begin_frame().
    const std::vector<std::uint32_t>& pixels() const { return pixels_; }  // 0x00RRGGBB
    // Colours while BLANK_N is high between the begin of HS and the picture; known unless BLANK_N
    // says where the picture is.
    bool has_colour_in_porch() const { return colour_in_porch_; }
    // A row has changed since the last call; true at the first one.
    bool consume_is_new() { return std::exchange(is_new_, false); }
    const Placement& place() const { return place_; }

private:
    void end_line();
    void store(const std::uint32_t* pins, unsigned count, bool black);
    const std::uint32_t* row();

    Placement place_;
    std::uint64_t left_;    // sample of the line in which the picture begins, unless by BLANK_N
    double left_fraction_;  // what is missing in that
    LinePhase phase_;
    std::vector<std::uint32_t> samples_;  // of a picture row
    std::vector<std::uint32_t> row_;      // its pixels; empty where they are the samples
    std::vector<std::uint32_t> pixels_;

    bool line_known_ = false;                 // HS has begun once
    bool in_step_ = false;                    // VS has begun after that
    std::uint64_t line_begin_ = 0, now_ = 0;  // in samples
    double early_ = 0;                        // before its first sample the row's edge came
    std::uint64_t line_ = 0;                  // of this frame
    unsigned stored_ = 0;                     // samples of this picture row
    unsigned rows_ = 0;                       // of this frame
    bool is_new_ = true;
    bool colour_in_porch_ = false;
};

}  // namespace sim
