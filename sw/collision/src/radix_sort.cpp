// radix_sort.cpp - see radix_sort.h
#include "radix_sort.h"

#include <array>

namespace collision::detail {
namespace {

constexpr unsigned DIGIT_BITS = 11, DIGITS = 3, FIRST_BIT = 32;

unsigned digit(std::uint64_t key, unsigned pass) {
    return key >> (FIRST_BIT + DIGIT_BITS * pass) & ((1u << DIGIT_BITS) - 1);
}

}  // namespace

void radix_sort(std::vector<std::uint64_t>& keys, std::vector<std::uint64_t>& spare) {
    std::array<std::array<std::uint32_t, 1u << DIGIT_BITS>, DIGITS> places{};
    for (const std::uint64_t key : keys)
        for (unsigned pass = 0; pass < DIGITS; ++pass) ++places[pass][digit(key, pass)];
    spare.resize(keys.size());
    for (unsigned pass = 0; pass < DIGITS; ++pass) {
        if (keys.empty() || places[pass][digit(keys[0], pass)] == keys.size()) continue;
        std::uint32_t place = 0;
        for (std::uint32_t& of_digit : places[pass]) {
            const std::uint32_t count = of_digit;
            of_digit = place;
            place += count;
        }
        for (const std::uint64_t key : keys) spare[places[pass][digit(key, pass)]++] = key;
        keys.swap(spare);
    }
}

}  // namespace collision::detail
