// html.cpp - see html.h
#include "sim/page/html.h"

#include "sim/report/printable.h"

namespace sim::page {

std::string escape(std::string_view text) {
    std::string out;
    for (const char c : printable(text)) {
        switch (c) {
            case '&': out += "&amp;"; break;
            case '<': out += "&lt;"; break;
            case '>': out += "&gt;"; break;
            case '"': out += "&quot;"; break;
            case '\'': out += "&#39;"; break;
            default: out += c;
        }
    }
    return out;
}

std::string data_url(const std::vector<std::uint8_t>& png) {
    constexpr char DIGITS[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out = "data:image/png;base64,";
    out.reserve(out.size() + (png.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < png.size(); i += 3) {
        const std::size_t count = png.size() - i;
        const unsigned three = static_cast<unsigned>(png[i] << 16) |
                               (count > 1 ? static_cast<unsigned>(png[i + 1] << 8) : 0u) |
                               (count > 2 ? png[i + 2] : 0u);
        out += DIGITS[three >> 18];
        out += DIGITS[three >> 12 & 63];
        out += count > 1 ? DIGITS[three >> 6 & 63] : '=';
        out += count > 2 ? DIGITS[three & 63] : '=';
    }
    return out;
}

}  // namespace sim::page
