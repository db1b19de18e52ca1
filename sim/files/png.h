// png.h - pictures: to PNG, from PNG, compared
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace sim {

struct Image {
    unsigned width = 0;
    unsigned height = 0;
    std::vector<std::uint8_t> rgb;  // rows from the top, three bytes per pixel

    bool operator==(const Image& other) const {
        return width == other.width && height == other.height && rgb == other.rgb;
    }
};

class PngError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// 8-bit RGB.  Unfiltered rows at zlib level 1: of all filters and strategies the fastest for thin
// lines on black, each pixel doubled 2 x 2 (1.6 ms and 23 KB for 640 x 480 on the reference
// machine; the Up filter makes 19 KB of it in 2.0 ms).
std::vector<std::uint8_t> encode_png(const Image& image);

// Any PNG of at most 4096 x 4096; grey, palette and 16-bit become 8-bit RGB, alpha goes onto black.
// PngError: not a PNG, cut short, damaged, too large.
Image decode_png(std::string_view bytes);

// The same from a file; the messages begin with the path.  IoError when it can not be read.
Image read_png(const std::filesystem::path& path);

void write_png(const std::filesystem::path& path, const Image& image);

// Both images must be of one size: std::invalid_argument.
std::size_t differing_pixels(const Image& a, const Image& b);

// For people: `b` in dark grey, red where it differs from `a`.
Image difference_image(const Image& a, const Image& b);

}  // namespace sim
