// film.h - some of a run's pictures, half as wide and high, for a strip on a page
//
// Pictures at the end of steps stay.  Of the others every n-th new one is kept; when they are too
// many or too large, every second of them goes and n doubles.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/scenario/observations.h"

namespace sim::page {

class Film {
public:
    static constexpr std::size_t MOST = 150, MOST_OF_STEPS = 300;
    static constexpr std::size_t MOST_BYTES = 1'000'000;  // of the PNGs that are not of steps

    struct Picture {
        std::uint64_t number;  // of its frame
        double time_s;
        bool of_step;
        std::vector<std::uint8_t> png;
    };

    // A new picture, which `eyes` see now.
    void show(double time_s, const Observations& eyes);
    // A step is done: the picture seen now stays.  Its number, or 0 if there is none or
    // enough are kept.
    std::uint64_t keep(const Observations& eyes);

    const std::vector<Picture>& pictures() const { return pictures_; }
    std::uint64_t shown() const { return shown_; }

private:
    void thin_out();

    std::vector<Picture> pictures_;
    std::uint64_t shown_ = 0, every_ = 1;
    std::size_t others_ = 0, other_bytes_ = 0, of_steps_ = 0;
    std::uint64_t number_ = 0;  // of the last that was shown
    double time_s_ = 0;
};

// Each pixel is the mean of four; an odd row or column is left out.
Image half_size(const Image& image);

}  // namespace sim::page
