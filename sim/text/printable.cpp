// printable.cpp - UTF-8 checks and escapes
#include "sim/text/printable.h"

#include <fmt/format.h>

namespace sim {

namespace {

bool is_safe(char32_t c) {
    if (c < 0x20 || (c >= 0x7F && c < 0xA0)) return false;  // C0, DEL, C1
    if (c == 0x2028 || c == 0x2029) return false;           // line breaks to some readers
    if (c >= 0x200E && c <= 0x200F) return false;           // left-to-right marks ...
    if (c >= 0x202A && c <= 0x202E) return false;           // ... and overrides
    if (c >= 0x2066 && c <= 0x2069) return false;
    return (c & 0xFFFE) != 0xFFFE && (c < 0xFDD0 || c > 0xFDEF);  // noncharacters
}

bool is_plain(char c) { return c >= ' ' && c <= '~'; }

}  // namespace

std::optional<char32_t> next_utf8(std::string_view text, std::size_t& at) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(at++);
    if (first < 0x80) return first;
    const unsigned more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
    if (first < 0xC2 || first > 0xF4 || at + more > text.size()) return std::nullopt;
    char32_t c = first & (0x3Fu >> more);
    for (unsigned i = 0; i < more; ++i) {
        if ((byte(at + i) & 0xC0u) != 0x80u) return std::nullopt;
        c = c << 6 | (byte(at + i) & 0x3Fu);
    }
    const bool overlong = (more == 2 && c < 0x800) || (more == 3 && c < 0x10000);
    if (overlong || c > 0x10FFFF || (c >= 0xD800 && c < 0xE000)) return std::nullopt;
    at += more;
    return c;
}

bool is_utf8(std::string_view text) {
    for (std::size_t at = 0; at < text.size();)
        if (!next_utf8(text, at)) return false;
    return true;
}

std::string printable(std::string_view text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t begin = at;
        while (at < text.size() && is_plain(text[at])) ++at;
        if (at > begin) {
            out += text.substr(begin, at - begin);
            continue;
        }
        const auto c = next_utf8(text, at);
        if (c && is_safe(*c)) {
            out += text.substr(begin, at - begin);
            continue;
        }
        for (const char b : text.substr(begin, at - begin))
            out += fmt::format("\\x{:02x}", static_cast<unsigned char>(b));
    }
    return out;
}

}  // namespace sim
