// maker.h - makes random instructions of a table's rows (encodings.h).
#pragma once

#include <cstdint>
#include <random>

#include "tb/sim/arm_core/encodings.h"

namespace tb::core {

using Random = std::mt19937_64;

// Numbers of the registers that rows write only by write-back.
struct Registers {
    unsigned low_base = 0, low_any = 0, high_any = 0, low_index = 0, high_index = 0;
};

class Maker {
public:
    Maker(Random& random, bool thumb);

    const Registers& registers() const { return registers_; }
    bool chance(unsigned percent) { return below(100) < percent; }
    unsigned below(unsigned end) { return static_cast<unsigned>(random_() % end); }
    std::uint32_t word(const Encoding& row);

    // Reserves a register for the letter t, which no row writes meanwhile; and releases it.
    void take(unsigned highest = 12);
    unsigned held() const { return held_; }
    void give_back() { free_ |= 1u << held_; }
    void keep(unsigned number) { free_ &= ~(1u << number); }  // for good

private:
    unsigned register_of(unsigned set, unsigned highest);
    std::uint32_t attempt(const char* bits);
    std::uint32_t choose(char letter, unsigned width, bool half);

    Random& random_;
    bool thumb_;
    Registers registers_;
    unsigned free_ = 0, written_ = 16, held_ = 0;
};

}  // namespace tb::core
