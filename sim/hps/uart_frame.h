// uart_frame.h - a character on the wire of a UART: its bits, and the receiver that samples them
//
// A frame is a start bit, 5 to 8 bits of data from the lowest on, perhaps a parity bit, and 1, 1.5
// or 2 stop bits.  The receiver looks at the middle of each bit and at the first stop bit alone.
#pragma once

#include <cstdint>
#include <optional>

namespace sim {

// LCR's bits say the format.
struct UartFormat {
    std::uint32_t lcr;
    std::uint64_t bit_ps;  // 0: there is no baud rate

    unsigned data_bits() const { return 5 + (lcr & 3); }
    bool has_parity() const { return lcr >> 3 & 1; }
    unsigned bits() const { return 1 + data_bits() + has_parity() + 1; }  // with one stop bit
    bool parity_of(unsigned data) const {
        const bool is_odd = __builtin_parity(data), even = lcr >> 4 & 1;
        return is_odd == even;
    }
    // With the stop bits that LCR asks for.
    std::uint64_t frame_ps() const {
        const std::uint64_t stops = lcr & 4 ? data_bits() == 5 ? 3 : 4 : 2;  // halves
        return (1 + data_bits() + has_parity()) * bit_ps + stops * bit_ps / 2;
    }
    // Bit n is the level of the frame's bit n.
    std::uint32_t frame(std::uint8_t character) const {
        const unsigned data = character & ((1u << data_bits()) - 1);
        std::uint32_t levels = data << 1, next = 1 + data_bits();
        if (has_parity()) levels |= static_cast<std::uint32_t>(parity_of(data)) << next++;
        return levels | 1u << next;
    }
};

class UartReceiver {
public:
    // Bits of LSR that belong to a character.
    static constexpr std::uint32_t PARITY_ERROR = 4, FRAMING_ERROR = 8, BREAK = 0x10;
    struct Character {
        std::uint8_t value;
        std::uint32_t errors;
    };

    // The wire has had its level up to now; returns a character that is complete by then.  To be
    // called again until there is none.
    std::optional<Character> pass_to(std::uint64_t now_ps, const UartFormat& format) {
        while (is_receiving_ && next_ps_ <= now_ps) {
            const unsigned bit = bit_++, last = format.bits() - 1;
            next_ps_ += format.bit_ps;
            bits_ |= static_cast<std::uint32_t>(level_) << bit;
            if (bit == 0 && level_) is_receiving_ = false;  // that was no start bit
            if (bit < last) continue;
            is_receiving_ = false;
            const std::uint32_t data = bits_ >> 1 & ((1u << format.data_bits()) - 1);
            const bool parity = bits_ >> (1 + format.data_bits()) & 1;
            std::uint32_t errors = 0;
            if (format.has_parity() && parity != format.parity_of(data)) errors |= PARITY_ERROR;
            if (!level_) errors |= bits_ ? FRAMING_ERROR : FRAMING_ERROR | BREAK;
            return Character{static_cast<std::uint8_t>(data), errors};
        }
        return {};
    }
    // The wire's level moves; after pass_to().
    void move(bool level, std::uint64_t now_ps, const UartFormat& format) {
        if (level == level_) return;
        level_ = level;
        if (level || is_receiving_ || format.bit_ps == 0) return;
        is_receiving_ = true;
        next_ps_ = now_ps + format.bit_ps / 2;
        bit_ = 0;
        bits_ = 0;
    }
    // When the character that comes is complete; nothing: none comes.
    std::optional<std::uint64_t> due_ps(const UartFormat& format) const {
        if (!is_receiving_) return {};
        return next_ps_ + (format.bits() - 1 - bit_) * format.bit_ps;
    }

private:
    bool level_ = true, is_receiving_ = false;
    std::uint64_t next_ps_ = 0;  // the middle of bit_
    unsigned bit_ = 0;
    std::uint32_t bits_ = 0;
};

}  // namespace sim
