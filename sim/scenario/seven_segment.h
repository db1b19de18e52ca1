// seven_segment.h - what a seven-segment digit can show
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sim {

constexpr unsigned HEX_DIGITS = 6;

// Segments g..a in bits 6:0, 1 = lit; [0] is HEX0, the rightmost.
using HexSegments = std::array<std::uint8_t, HEX_DIGITS>;

struct Glyph {
    char character;
    std::uint8_t segments;
};

// One character a pattern, one pattern a character: B and D have the shapes of b and d.
constexpr Glyph GLYPHS[] = {
    {'0', 0x3F}, {'1', 0x06}, {'2', 0x5B}, {'3', 0x4F}, {'4', 0x66}, {'5', 0x6D},
    {'6', 0x7D}, {'7', 0x07}, {'8', 0x7F}, {'9', 0x6F}, {'A', 0x77}, {'B', 0x7C},
    {'C', 0x39}, {'D', 0x5E}, {'E', 0x79}, {'F', 0x71}, {' ', 0x00}, {'-', 0x40},
    {'_', 0x08}, {'H', 0x76}, {'L', 0x38}, {'P', 0x73}, {'U', 0x3E}, {'n', 0x54},
    {'o', 0x5C}, {'r', 0x50}, {'t', 0x78}, {'u', 0x1C}, {'y', 0x6E},
};

// Six characters, HEX5 first; nothing for any other length or a character without a glyph.
std::optional<HexSegments> hex_segments(std::string_view text);

// The six characters, '?' for a pattern without a glyph.
std::string hex_text(const HexSegments& segments);

}  // namespace sim
