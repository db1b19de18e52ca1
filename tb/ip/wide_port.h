// wide_port.h - fields of a Verilated port of more than 64 bits
#pragma once

#include <verilated.h>

#include <cstdint>

namespace sim::test {

inline void set(EData* port, unsigned first, unsigned bits, std::uint64_t value) {
    for (unsigned n = 0; n < bits; ++n) {
        EData& word = port[(first + n) / 32];
        const EData bit = EData{1} << (first + n) % 32;
        word = value >> n & 1 ? word | bit : word & ~bit;
    }
}

inline std::uint64_t get(const EData* port, unsigned first, unsigned bits) {
    std::uint64_t value = 0;
    for (unsigned n = 0; n < bits; ++n)
        value |= std::uint64_t{port[(first + n) / 32] >> (first + n) % 32 & 1} << n;
    return value;
}

}  // namespace sim::test
