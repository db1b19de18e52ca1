#include "sim/debug/gdb_packet.h"

#include <algorithm>

namespace sim {

namespace {

constexpr char ESCAPE = '}', FLIP = 0x20, CTRL_C = 3;
constexpr char DIGITS[] = "0123456789abcdef";

int digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

}  // namespace

std::optional<GdbEvent> GdbPacketReader::feed(char byte) {
    switch (state_) {
        case State::BETWEEN:
            if (byte == '-') return GdbEvent::REPEAT;
            if (byte == CTRL_C) return GdbEvent::INTERRUPT;
            if (byte != '$') return std::nullopt;
            state_ = State::TEXT;
            text_.clear();
            sum_ = 0;
            too_long_ = false;
            return std::nullopt;
        case State::TEXT:
            if (byte == '#') {
                state_ = State::SUM_HIGH;
                return std::nullopt;
            }
            sum_ += static_cast<unsigned char>(byte);
            if (byte == ESCAPE) {
                state_ = State::ESCAPED;
                return std::nullopt;
            }
            break;
        case State::ESCAPED:
            sum_ += static_cast<unsigned char>(byte);
            byte = static_cast<char>(byte ^ FLIP);
            state_ = State::TEXT;
            break;
        case State::SUM_HIGH:
            received_sum_ = digit(byte) * 16;
            state_ = State::SUM_LOW;
            return std::nullopt;
        case State::SUM_LOW: {
            state_ = State::BETWEEN;
            const int low = digit(byte);
            const bool right = received_sum_ >= 0 && low >= 0 &&
                               static_cast<unsigned>(received_sum_ + low) == sum_ % 256;
            return right && !too_long_ ? GdbEvent::PACKET : GdbEvent::CORRUPT;
        }
    }
    if (text_.size() < GDB_PACKET_BYTES)
        text_ += byte;
    else
        too_long_ = true;
    return std::nullopt;
}

std::string gdb_packet(std::string_view text) {
    std::string packet = "$";
    for (const char c : text) {
        const bool special = c == '$' || c == '#' || c == '*' || c == ESCAPE;
        if (special) packet += ESCAPE;
        packet += special ? static_cast<char>(c ^ FLIP) : c;
    }
    unsigned sum = 0;
    for (std::size_t i = 1; i < packet.size(); ++i) sum += static_cast<unsigned char>(packet[i]);
    const auto last = static_cast<unsigned char>(sum);
    return packet + "#" + to_hex(&last, 1);
}

std::string to_hex(const void* data, std::size_t bytes) {
    const auto* byte = static_cast<const unsigned char*>(data);
    std::string digits;
    digits.reserve(2 * bytes);
    for (std::size_t i = 0; i < bytes; ++i) {
        digits += DIGITS[byte[i] >> 4];
        digits += DIGITS[byte[i] & 15];
    }
    return digits;
}

std::optional<std::string> from_hex(std::string_view digits) {
    if (digits.size() % 2 != 0) return std::nullopt;
    std::string bytes;
    bytes.reserve(digits.size() / 2);
    for (std::size_t i = 0; i < digits.size(); i += 2) {
        const int high = digit(digits[i]), low = digit(digits[i + 1]);
        if (high < 0 || low < 0) return std::nullopt;
        bytes += static_cast<char>(high * 16 + low);
    }
    return bytes;
}

std::optional<std::uint64_t> GdbFields::number() {
    std::uint64_t value = 0;
    std::size_t count = 0;
    while (count < rest_.size() && digit(rest_[count]) >= 0) {
        value = value << 4 | static_cast<unsigned>(digit(rest_[count]));
        ++count;
    }
    const bool right = count >= 1 && count <= 16;
    rest_.remove_prefix(right ? count : rest_.size());
    return right ? std::optional{value} : std::nullopt;
}

std::optional<std::uint32_t> GdbFields::word() {
    const auto value = number();
    if (!value || *value > 0xFFFFFFFF) return std::nullopt;
    return static_cast<std::uint32_t>(*value);
}

bool GdbFields::skip(std::string_view expected) {
    const bool right = rest_.substr(0, expected.size()) == expected;
    rest_.remove_prefix(right ? expected.size() : rest_.size());
    return right;
}

}  // namespace sim
