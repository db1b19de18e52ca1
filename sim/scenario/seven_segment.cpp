// seven_segment.cpp - text to segments and back
#include "sim/scenario/seven_segment.h"

#include <algorithm>

namespace sim {

HexSegments segments_of(std::uint64_t lit) {
    HexSegments segments{};
    for (unsigned i = 0; i < HEX_DIGITS; ++i)
        segments[i] = static_cast<std::uint8_t>((lit >> 7 * i & 0x7f) |
                                                (lit >> (7 * HEX_DIGITS + i) & 1) << 7);
    return segments;
}

unsigned digits_shown(const HexSegments& segments) {
    unsigned count = HEX_DIGITS;
    while (count > FEWEST_DIGITS && !segments[count - 1]) --count;
    return count;
}

bool is_hex_text(std::string_view text) {
    return text.size() >= FEWEST_DIGITS && text.size() <= HEX_DIGITS &&
           std::all_of(text.begin(), text.end(), [](char c) {
               return std::any_of(std::begin(GLYPHS), std::end(GLYPHS),
                                  [c](Glyph g) { return g.character == c; });
           });
}

std::string hex_text(const HexSegments& segments, std::string_view expected) {
    std::string text;
    const unsigned count = std::max(digits_shown(segments), static_cast<unsigned>(expected.size()));
    for (unsigned place = 0; place < count; ++place) {
        const unsigned pattern = segments[count - 1 - place] & 0x7F;
        char character = '?';
        for (const Glyph& glyph : GLYPHS) {
            if (glyph.segments != pattern) continue;
            const bool wanted = place < expected.size() && expected[place] == glyph.character;
            if (wanted || character == '?') character = glyph.character;
        }
        text += character;
    }
    return text;
}

}  // namespace sim
