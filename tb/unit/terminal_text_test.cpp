// terminal_text.h: text and colours reach a terminal, what would change its modes does not.
#include "sim/text/terminal_text.h"

#include <gtest/gtest.h>

namespace {

using sim::TerminalText;

std::string shown(const std::string& bytes) { return TerminalText{}.show(bytes); }

TEST(TerminalText, ShowsTextAndWhatMovesWithinIt) {
    const std::string text = "one\ttwo\r\nthree\b\a \xC3\xA4 \xE2\x82\xAC \xF0\x9F\x98\x80";
    EXPECT_EQ(shown(text), text);
}

TEST(TerminalText, LetsCursorErasingAndColoursThrough) {
    const std::string text = "\x1b[2J\x1b[H\x1b[10;20f\x1b[1;31mred\x1b[0m\x1b[K\x1b[A";
    EXPECT_EQ(shown(text), text);
}

TEST(TerminalText, ShowsOtherSequencesAsText) {
    EXPECT_EQ(shown("\x1b]0;title\a"), "\\x1b]0;title\a");
    EXPECT_EQ(shown("\x1b[6n"), "\\x1b[6n") << "the terminal would answer";
    EXPECT_EQ(shown("\x1b[?1049h"), "\\x1b[?1049h");
    EXPECT_EQ(shown("\x1b(0"), "\\x1b(0");
    EXPECT_EQ(shown("\x1b[" + std::string(100, '1') + "m").substr(0, 5), "\\x1b[");
}

TEST(TerminalText, ShowsBytesThatAreNoTextAsText) {
    EXPECT_EQ(shown("\xFF\x01\x7F\xC3(\x9B"
                    "6n.."),
              "\\xff\\x01\\x7f\\xc3(\\x9b6n..");
}

TEST(TerminalText, JoinsCharactersAndSequencesThatComeInPieces) {
    const std::string text = "\xE2\x82\xAC\x1b[31mred";
    TerminalText pieces;
    std::string all;
    for (const char c : text) all += pieces.show({&c, 1});
    EXPECT_EQ(all, text);
}

TEST(TerminalText, EndsWithWhatWasKeptAndWithoutColours) {
    TerminalText text;
    EXPECT_EQ(text.show("\x1b[31mred\xE2\x82"), "\x1b[31mred");
    EXPECT_EQ(text.end(), "\\xe2\\x82\x1b[m");
    EXPECT_EQ(text.end(), "");
}

}  // namespace
