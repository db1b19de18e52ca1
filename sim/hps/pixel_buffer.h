// pixel_buffer.h - the picture in the FPGA's memory that the monitor shows, as a program finds it
#pragma once

#include <cstdint>

namespace sim {

struct PixelBuffer {
    std::uint32_t base;                  // of the processor's addresses
    unsigned width, height, bits, line;  // bits of a pixel: 16 (5-6-5) or 32; bytes of a line
    std::uint32_t bytes;                 // of its memory, line * height or more
    // Of a frame reader, which a driver has to start: its registers, and the bits of its memory's
    // words.  0: the FPGA shows the picture by itself.
    std::uint32_t frame_reader = 0;
    unsigned word = 0;
};

}  // namespace sim
