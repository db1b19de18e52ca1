// matroska.h - raw pictures and sound with their times, as bytes for a program that encodes them
//
// A cluster per block, so that each block has its own time in microseconds.
// Source: RFC 8794 (EBML), RFC 9559 (Matroska).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sim {

class Matroska {
public:
    Matroska(unsigned width, unsigned height, unsigned rate_hz);

    // Once, first.
    std::string head() const;
    // 0x00RRGGBB, row by row; shown from this time on.
    std::string picture(const std::vector<std::uint32_t>& pixels, double time_s) const;
    // Left and right in turn, 16 bits, after what came before.
    std::string sound(const std::vector<std::int16_t>& samples);

private:
    const unsigned width_, height_, rate_hz_;
    std::uint64_t written_ = 0;  // samples of each channel
};

}  // namespace sim
