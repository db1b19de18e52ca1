// wire_test.cpp - messages between server and simulation: whole, in order, counted while they wait
#include "sim/live/wire.h"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include <memory>

#include "sim/live/text_stream.h"

namespace {

using sim::live::Kind;
using sim::live::TextStream;
using sim::live::Wire;

class WireTest : public testing::Test {
protected:
    std::unique_ptr<Wire> near, far;

    void SetUp() override {
        int ends[2];
        ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
        near = std::make_unique<Wire>(ends[0]);
        far = std::make_unique<Wire>(ends[1]);
    }
    // A message of its own, 100,000 bytes long.
    static std::string message(int number) { return std::string(100'000, char('a' + number % 26)); }
};

TEST_F(WireTest, MessagesArriveWholeInOrderWithTheirKinds) {
    near->send(Kind::TEXT, "{}");
    near->send(Kind::SOUND, "");
    near->send(Kind::PICTURE, std::string("\0\1", 2));
    ASSERT_TRUE(far->poll(1000));
    auto first = far->receive(), second = far->receive(), third = far->receive();
    ASSERT_TRUE(first && second && third);
    EXPECT_EQ(first->bytes, "{}");
    EXPECT_EQ(first->kind, Kind::TEXT);
    EXPECT_EQ(second->bytes, "");
    EXPECT_EQ(second->kind, Kind::SOUND);
    EXPECT_EQ(third->bytes, std::string("\0\1", 2));
    EXPECT_EQ(third->kind, Kind::PICTURE);
    EXPECT_FALSE(far->receive());
}

TEST_F(WireTest, QueuesAndCountsUnreadMessages) {
    for (int n = 0; n < 50; ++n) near->send(Kind::PICTURE, message(n));
    const std::size_t waiting = near->unsent();
    EXPECT_GT(waiting, 1'000'000u);  // what a socket holds is less
    EXPECT_TRUE(near->poll(0));
    EXPECT_EQ(near->unsent(), waiting);
    int next = 0;
    for (int turn = 0; next < 50 && turn < 10'000; ++turn) {
        ASSERT_TRUE(far->poll(0));
        while (const auto got = far->receive()) ASSERT_EQ(got->bytes, message(next++)) << next;
        ASSERT_TRUE(near->poll(0));
    }
    EXPECT_EQ(next, 50);
    EXPECT_EQ(near->unsent(), 0u);
}

TEST_F(WireTest, DetectsAClosedPeerAfterItsLastMessage) {
    near->send(Kind::TEXT, "bye");
    near.reset();
    EXPECT_FALSE(far->poll(1000));
    const auto last = far->receive();
    ASSERT_TRUE(last);
    EXPECT_EQ(last->bytes, "bye");
    far->send(Kind::TEXT, "into nothing");
    EXPECT_EQ(far->unsent(), 0u);
}

TEST(TextStreamTest, KeepsTheBeginningOfACharacterUntilItIsWhole) {
    TextStream stream;
    std::string all;
    for (const char byte : std::string{"a\xC3\xA4\xE2\x82\xAC\xF0\x9F\x98\x80z"}) {
        stream.print(byte);
        const std::string piece = stream.remove();
        EXPECT_TRUE(piece.empty() || (piece[0] & 0xC0) != 0x80) << "a rest of a character";
        all += piece;
    }
    EXPECT_EQ(all, "a\xC3\xA4\xE2\x82\xAC\xF0\x9F\x98\x80z");
}

TEST(TextStreamTest, DoesNotWaitForWhatIsNoCharacter) {
    TextStream stream;
    for (const char byte : std::string{"\x80\xBF\xBF\xBF"}) stream.print(byte);
    EXPECT_EQ(stream.remove(), "\x80\xBF\xBF\xBF");
    stream.print('\xC3');
    EXPECT_EQ(stream.remove(), "");
    stream.print('x');
    EXPECT_EQ(stream.remove(), "\xC3x");
}

}  // namespace
