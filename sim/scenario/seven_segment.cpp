// seven_segment.cpp - text to segments and back
#include "sim/scenario/seven_segment.h"

#include <algorithm>

namespace sim {

std::optional<HexSegments> hex_segments(std::string_view text) {
    if (text.size() != HEX_DIGITS) return std::nullopt;
    HexSegments segments{};
    for (unsigned i = 0; i < HEX_DIGITS; ++i) {
        const auto* glyph = std::find_if(std::begin(GLYPHS), std::end(GLYPHS),
                                         [&](Glyph g) { return g.character == text[i]; });
        if (glyph == std::end(GLYPHS)) return std::nullopt;
        segments[HEX_DIGITS - 1 - i] = glyph->segments;
    }
    return segments;
}

std::string hex_text(const HexSegments& segments) {
    std::string text;
    for (unsigned i = HEX_DIGITS; i-- > 0;) {
        const auto* glyph = std::find_if(std::begin(GLYPHS), std::end(GLYPHS), [&](Glyph g) {
            return g.segments == (segments[i] & 0x7F);
        });
        text += glyph == std::end(GLYPHS) ? '?' : glyph->character;
    }
    return text;
}

}  // namespace sim
