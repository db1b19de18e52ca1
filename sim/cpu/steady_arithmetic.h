// steady_arithmetic.h - what ARM instructions compute from fixed values: fields, shifts, flags
#pragma once

#include <algorithm>
#include <cstdint>

#include "sim/cpu/linear.h"

namespace sim::steady {

constexpr unsigned LINK = 14, PC = 15;
constexpr unsigned ALWAYS = 14, SPECIAL = 15;                     // conditions
constexpr unsigned N = 8, Z = 4, C = 2, V = 1;                    // of NZCV
constexpr std::uint32_t THUMB = 1u << 5;                          // CPSR
constexpr std::uint32_t STATE = 0x0600FC00 | 1u << 9 | 1u << 24;  // CPSR: IT, big-endian, Jazelle
// Operations of data processing.
constexpr unsigned AND = 0, EOR = 1, SUB = 2, RSB = 3, ADD = 4, ADC = 5, SBC = 6, RSC = 7, TST = 8,
                   TEQ = 9, CMP = 10, CMN = 11, ORR = 12, MOV = 13, BIC = 14, MVN = 15;
constexpr int UNCHANGED = -1, UNKNOWN = -2;  // carries

constexpr std::uint32_t bits(std::uint32_t word, unsigned high, unsigned low) {
    return word >> low & ((2u << (high - low)) - 1);
}
constexpr bool matches(std::uint32_t word, std::uint32_t mask, std::uint32_t value) {
    return (word & mask) == value;
}
constexpr Linear fixed(std::uint32_t value) { return {value, 0}; }
constexpr std::uint32_t extended(std::uint32_t value, unsigned width) {
    const std::uint32_t sign = 1u << (width - 1);
    return (value ^ sign) - sign;
}

// A fixed value, shifted; `carry` comes out, or stays.
inline std::uint32_t shift(std::uint32_t value, unsigned type, unsigned amount, int& carry) {
    if (amount == 0) return value;
    const auto bit = [value](unsigned n) { return static_cast<int>(value >> n & 1); };
    switch (type) {
        case 0:
            carry = amount <= 32 ? bit(32 - amount) : 0;
            return amount < 32 ? value << amount : 0;
        case 1:
            carry = amount <= 32 ? bit(amount - 1) : 0;
            return amount < 32 ? value >> amount : 0;
        case 2:
            carry = bit(std::min(amount, 32u) - 1);
            return static_cast<std::uint32_t>(static_cast<std::int32_t>(value) >>
                                              std::min(amount, 31u));
        default:
            carry = bit((amount - 1) % 32);
            return amount % 32 ? value >> amount % 32 | value << (32 - amount % 32) : value;
    }
}

// NZCV of a + b + carry; a - b is a + ~b + 1.
inline unsigned flags_of_sum(std::uint32_t a, std::uint32_t b, unsigned carry) {
    const std::uint64_t sum = std::uint64_t{a} + b + carry;
    const auto result = static_cast<std::uint32_t>(sum);
    return (result >> 31 ? N : 0) | (result == 0 ? Z : 0) | (sum >> 32 ? C : 0) |
           ((~(a ^ b) & (a ^ result)) >> 31 ? V : 0);
}

}  // namespace sim::steady
