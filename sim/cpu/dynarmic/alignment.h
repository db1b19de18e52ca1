// alignment.h - of what the address of an instruction's data must be a multiple (ARM DDI 0406C,
// A3.2.1).
#pragma once

#include <cstdint>

namespace sim {

constexpr std::uint32_t ALIGNMENT_FAULT = 0x1;  // as DFSR has it

struct Alignment {
    std::uint32_t bytes = 1;  // 1: any address will do
    // In Normal memory, too, whatever SCTLR.A says; otherwise only with SCTLR.A, or in Device and
    // Strongly-ordered memory.
    bool always = false;
    // A piece of the data is shorter, so an address may be wrong although each piece is aligned.
    bool beyond_pieces = false;
};

// VLD1 and VST1 of bytes, halfwords or words with :64, as one of doublewords, which loads and
// stores the same: then each piece is as long as its alignment.  Others as they are.
std::uint32_t as_doublewords(std::uint32_t word, bool thumb);

// Of a load or store; of other instructions it says nothing.
Alignment alignment(std::uint32_t word, bool thumb);

}  // namespace sim
