// gdb_packet.h - the envelope of GDB's remote serial protocol: $text#sum, + and -, Ctrl-C.
//
// Source: "Debugging with GDB", E.1 Overview.  The checksum is the sum of the raw bytes, modulo
// 256; '}' and a byte XOR 0x20 stand for a byte with a special meaning.
//
// Not handled: run-length encoding (not sent to a stub) and sequence numbers (obsolete).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sim {

constexpr std::size_t GDB_PACKET_BYTES = 0x4000;  // longest text, as announced to GDB

enum class GdbEvent {
    PACKET,     // its text is ready
    CORRUPT,    // wrong checksum or too long: must be requested again
    REPEAT,     // '-': the last answer did not arrive
    INTERRUPT,  // Ctrl-C
};

// Takes the bytes as they come; any bytes are allowed.
class GdbPacketReader {
public:
    std::optional<GdbEvent> feed(char byte);
    const std::string& text() const { return text_; }  // of the last PACKET, unescaped

private:
    enum class State { BETWEEN, TEXT, ESCAPED, SUM_HIGH, SUM_LOW } state_ = State::BETWEEN;
    std::string text_;
    unsigned sum_ = 0;      // so far
    int received_sum_ = 0;  // the sender's sum; negative: not a number
    bool too_long_ = false;
};

// $text#sum, escaped.
std::string gdb_packet(std::string_view text);

// Two digits per byte, lower case.
std::string to_hex(const void* data, std::size_t bytes);
// No value unless the text consists of pairs of digits.
std::optional<std::string> from_hex(std::string_view digits);

// Parses a packet's text from left to right.  After an error every call fails.
class GdbFields {
public:
    explicit GdbFields(std::string_view text) : rest_{text} {}

    // One to sixteen digits.
    std::optional<std::uint64_t> number();
    // At most 32 bits.
    std::optional<std::uint32_t> word();
    bool skip(std::string_view expected);
    std::string_view rest() const { return rest_; }

private:
    std::string_view rest_;
};

}  // namespace sim
