// terminal_text.cpp - see terminal_text.h
#include "sim/text/terminal_text.h"

#include <cstddef>

#include "sim/text/printable.h"

namespace sim {

namespace {

constexpr char ESCAPE = '\x1b', COLOURS = 'm';
constexpr std::string_view PLAIN_CONTROLS = "\n\r\t\b\a";
// Of the sequences ESC [ parameters letter: cursor, erasing, scrolling, saved position, colours.
constexpr std::string_view LETTERS = "ABCDEFGHJKSTdfsum";
constexpr std::size_t LONGEST = 32;

struct Sequence {
    std::size_t bytes;  // 0: none that is let through
    bool complete;
};

Sequence sequence_at(std::string_view text) {
    if (text.size() > 1 && text[1] != '[') return {0, true};
    std::size_t at = 2;
    while (at < text.size() && text[at] >= '0' && text[at] <= ';') ++at;
    if (at >= LONGEST) return {0, true};
    if (at >= text.size()) return {0, false};
    return {LETTERS.find(text[at]) == std::string_view::npos ? 0 : at + 1, true};
}

// Bytes that the character which begins here has, as its first one says.
std::size_t length_of(char first) {
    const auto byte = static_cast<unsigned char>(first);
    return byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : byte >= 0xC2 ? 2 : 1;
}

}  // namespace

std::string TerminalText::show(std::string_view bytes) {
    kept_ += bytes;
    const std::string_view text = kept_;
    std::string shown;
    std::size_t at = 0;
    while (at < text.size()) {
        std::size_t count = 1;
        if (text[at] == ESCAPE) {
            const Sequence sequence = sequence_at(text.substr(at));
            if (!sequence.complete) break;
            if (sequence.bytes > 0) {
                shown += text.substr(at, sequence.bytes);
                at += sequence.bytes;
                coloured_ |= text[at - 1] == COLOURS;
                continue;
            }
        } else if (PLAIN_CONTROLS.find(text[at]) != std::string_view::npos) {
            shown += text[at++];
            continue;
        } else {
            count = length_of(text[at]);
            if (at + count > text.size()) break;
            std::size_t end = at;
            (void)next_utf8(text, end);  // one byte where it is not valid
            count = end - at;
        }
        shown += printable(text.substr(at, count));
        at += count;
    }
    kept_.erase(0, at);
    return shown;
}

std::string TerminalText::end() {
    std::string shown = printable(kept_);
    kept_.clear();
    if (coloured_) shown += "\x1b[m";
    coloured_ = false;
    return shown;
}

}  // namespace sim
