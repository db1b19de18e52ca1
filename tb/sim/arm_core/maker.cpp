#include "tb/sim/arm_core/maker.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace tb::core {

Maker::Maker(Random& random, bool thumb) : random_{random}, thumb_{thumb} {
    std::vector<unsigned> low{0, 1, 2, 3, 4, 5, 6, 7}, high{8, 9, 10, 11, 12};
    unsigned pairs;
    do {  // two pairs are left, of which one may be held
        std::shuffle(low.begin(), low.end(), random_);
        std::shuffle(high.begin(), high.end(), random_);
        free_ = 1u << 14;
        for (const unsigned r : {3, 4, 5, 6, 7}) free_ |= 1u << low[r];
        for (const unsigned r : {2, 3, 4}) free_ |= 1u << high[r];
        pairs = free_ & free_ >> 1 & 0x555;
    } while ((pairs & (pairs - 1)) == 0);
    registers_ = {low[0], low[1], high[0], low[2], high[1]};
}

std::uint32_t Maker::word(const Encoding& row) {
    for (unsigned tries = 0; tries < 20'000; ++tries) {
        const std::uint32_t word = attempt(row.bits);
        if (!row.allowed || row.allowed(word)) return word;
    }
    throw std::runtime_error{std::string{"no instruction fits "} + row.name};
}

void Maker::take(unsigned highest) {
    held_ = register_of(free_, highest);
    free_ &= ~(1u << held_);
}

unsigned Maker::register_of(unsigned set, unsigned highest) {
    unsigned r;
    do r = below(highest + 1);
    while (!(set >> r & 1));
    return r;
}

std::uint32_t Maker::attempt(const char* bits) {
    const std::size_t length = std::strlen(bits);
    const bool half = length == 16;
    std::uint32_t left[128] = {};
    for (std::size_t i = 0; i < length; ++i) ++left[static_cast<unsigned>(bits[i])];
    written_ = 16;
    std::uint32_t word = 0, value[128];
    bool known[128] = {};
    for (std::size_t i = 0; i < length; ++i) {
        const auto letter = static_cast<unsigned>(bits[i]);
        const auto position = static_cast<unsigned>(length - 1 - i);
        std::uint32_t one = 0;
        if (letter == '1') one = 1;
        if (letter == 'x') one = random_() >> 40 & 1;
        if (letter == 'l') one = (free_ >> position & 1) && chance(50);
        if (letter == 'L') one = position != 13 && position != 15 && chance(50);
        if (!std::strchr("01xlL", bits[i])) {
            if (!known[letter]) value[letter] = choose(bits[i], std::min(left[letter], 4u), half);
            known[letter] = true;
            one = value[letter] >> --left[letter] % 4 & 1;  // a register twice is the same
        }
        word = word << 1 | one;
    }
    return word;
}

std::uint32_t Maker::choose(char letter, unsigned width, bool half) {
    const unsigned highest = width == 3 ? 7 : 14;
    const unsigned sources = thumb_ ? 0x5FFF : 0x7FFF;
    switch (letter) {
        case 'c': return chance(60) ? 14 : below(14);
        case 'd':
        case 'e': return written_ = register_of(free_ & ~(1u << written_), highest);
        case 'r': return register_of(free_ & free_ >> 1 & 0x555, 12);
        case 'o': return 2 * below(6);
        case 'n':
        case 'm':
        case 's':
        case 'a': return register_of(sources, highest);
        case 'N':
        case 'M': return below(16);
        case 'p': return width == 3 || chance(60) ? registers_.low_base : 13;
        case 'P': return registers_.low_base;
        case 'q': return half || chance(50) ? registers_.low_any : registers_.high_any;
        case 'i': return registers_.low_index;
        case 'k': return registers_.high_index;
        case 't': return held_;
        default: throw std::runtime_error{"a letter that no field has"};
    }
}

}  // namespace tb::core
