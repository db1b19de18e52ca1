// seven_segment.h - what a seven-segment digit can show
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "sim/pins/pins.h"

namespace sim {

constexpr unsigned HEX_DIGITS = DIGITS, FEWEST_DIGITS = 6;

// The decimal point in bit 7, segments g..a in bits 6:0, 1 = lit; [0] is HEX0, the rightmost.
using HexSegments = std::array<std::uint8_t, HEX_DIGITS>;

// Of Lamps::hex.
HexSegments segments_of(std::uint64_t lit);

// Without dark ones left of the six that most boards have.
unsigned digits_shown(const HexSegments& segments);

struct Glyph {
    char character;
    std::uint8_t segments;
};

// Each character's usual form comes first; B and D have the shapes of b and d.  Programs write 6, 7
// and 9 in two forms each, and one form of 6 equals B.
constexpr Glyph GLYPHS[] = {
    {'0', 0x3F}, {'1', 0x06}, {'2', 0x5B}, {'3', 0x4F}, {'4', 0x66}, {'5', 0x6D}, {'6', 0x7D},
    {'7', 0x07}, {'8', 0x7F}, {'9', 0x6F}, {'A', 0x77}, {'B', 0x7C}, {'C', 0x39}, {'D', 0x5E},
    {'E', 0x79}, {'F', 0x71}, {' ', 0x00}, {'-', 0x40}, {'_', 0x08}, {'H', 0x76}, {'L', 0x38},
    {'P', 0x73}, {'U', 0x3E}, {'n', 0x54}, {'o', 0x5C}, {'r', 0x50}, {'t', 0x78}, {'u', 0x1C},
    {'y', 0x6E}, {'6', 0x7C}, {'7', 0x27}, {'9', 0x67},
};

// FEWEST_DIGITS to HEX_DIGITS characters with a glyph each, HEX0 last.
bool is_hex_text(std::string_view text);

// The digits as text without points, HEX0 last: FEWEST_DIGITS, or more up to the leftmost that
// shows something, and as many as are expected.  Each is the character of `expected` if the pattern
// is one of its forms, otherwise the first character with that pattern, '?' if there is none.
std::string hex_text(const HexSegments& segments, std::string_view expected = "");

}  // namespace sim
