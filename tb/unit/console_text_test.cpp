// console_text.h: text that was found counts as read, and new text is found after any amount of
// output.
#include "sim/scenario/console_text.h"

#include <gtest/gtest.h>

namespace {

using sim::ConsoleText;

struct Console : ConsoleText {
    void print_all(const std::string& text) {
        for (const char c : text) print(c);
    }
};

TEST(ConsoleText, IsConsumedUpToTheEndOfTheMatch) {
    Console console;
    console.print_all("one two three");
    EXPECT_TRUE(console.consume("two"));
    EXPECT_FALSE(console.consume("two"));
    EXPECT_FALSE(console.consume("one"));
    EXPECT_TRUE(console.consume(" three"));
    EXPECT_EQ(console.unread(), 0u);
}

TEST(ConsoleText, IsTakenAtItsFirstPlaceAndWithoutOverlaps) {
    Console console;
    console.print_all("aaab aa");
    EXPECT_TRUE(console.consume("aa"));
    EXPECT_EQ(console.unread(), 5u);
    EXPECT_TRUE(console.consume("aa"));
    EXPECT_FALSE(console.consume("a"));
}

TEST(ConsoleText, IsFoundWhenItComesInPieces) {
    Console console;
    console.print_all("re");
    EXPECT_FALSE(console.consume("ready"));
    console.print_all("area");
    EXPECT_FALSE(console.consume("ready"));
    console.print_all("dy!");
    EXPECT_TRUE(console.consume("ready"));
    EXPECT_EQ(console.unread(), 1u);
}

TEST(ConsoleText, IsLookedThroughFromTheBeginningForAnotherText) {
    Console console;
    console.print_all("one two");
    EXPECT_FALSE(console.consume("three"));
    EXPECT_TRUE(console.consume("one"));
}

TEST(ConsoleText, IsFoundAcrossTheEdgeOfForgottenText) {
    Console console;
    for (std::size_t i = 0; i < 2 * ConsoleText::LIMIT - 3; ++i) console.print('.');
    EXPECT_FALSE(console.consume("ready"));
    console.print_all("ready");
    EXPECT_EQ(console.forgotten(), ConsoleText::LIMIT);
    EXPECT_EQ(console.unread(), 2 * ConsoleText::LIMIT + 2);
    EXPECT_TRUE(console.consume("ready"));
    EXPECT_EQ(console.forgotten(), 0u);
}

TEST(ConsoleText, IsFoundEvenIfLongerThanTheKeptText) {
    Console console;
    std::string text;
    for (std::size_t i = 0; i < 3 * ConsoleText::LIMIT; ++i)
        text += static_cast<char>('a' + i * i % 23);
    console.print_all("before");
    EXPECT_FALSE(console.consume(text));
    for (std::size_t i = 0; i < 5 * ConsoleText::LIMIT; ++i) console.print('.');
    console.print_all(text);
    EXPECT_TRUE(console.consume(text));
}

TEST(ConsoleText, KeepsAsManyUnreadCharactersAsItPromises) {
    Console console;
    console.print('!');
    for (std::size_t i = 0; i < 2 * ConsoleText::LIMIT - 2; ++i) console.print('.');
    EXPECT_TRUE(console.consume("!"));
    console.print('?');
    for (std::size_t i = 0; i < ConsoleText::LIMIT - 1; ++i) console.print('.');
    EXPECT_TRUE(console.consume("?"));
    console.print('?');
    for (std::size_t i = 0; i < 2 * ConsoleText::LIMIT; ++i) console.print('.');
    EXPECT_FALSE(console.consume("?"));
    EXPECT_GT(console.forgotten(), 0u);
}

}  // namespace
