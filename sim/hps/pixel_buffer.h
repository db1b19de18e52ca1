// pixel_buffer.h - the picture in the FPGA's memory that the monitor shows, as a program finds it
#pragma once

#include <cstdint>

namespace sim {

struct PixelBuffer {
    std::uint32_t base;                  // of the processor's addresses
    unsigned width, height, bits, line;  // bits of a pixel: 16 (5-6-5) or 32; bytes of a line

    std::uint32_t bytes() const { return line * height; }
};

}  // namespace sim
