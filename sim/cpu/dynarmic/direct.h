// direct.h - single loads and stores, decoded: programs access device registers by these.
//
// LDR, STR and their kinds for bytes and halfwords, in ARM and Thumb, in all addressing modes.
// Source: ARM DDI 0406C, A5.3, A6.2.4, A6.3.7 - A6.3.10.
//
// Not among them: what loads pc, doubles, multiples, exclusives, VFP and NEON.
#pragma once

#include <cstdint>
#include <optional>

namespace sim {

struct SingleAccess {
    bool load;
    unsigned bytes;   // 1, 2, 4
    bool is_signed;   // of a load of fewer than 4
    unsigned target;  // the register that is loaded or stored
    unsigned base;
    std::uint32_t address;
    bool write_back;
    std::uint32_t new_base;  // where write_back
};

// `word` as in instructions.h.  `r`: r0 - r14 before the instruction; r15 is not read.  `pc`: of
// the instruction.
std::optional<SingleAccess> single_access(std::uint32_t word, bool thumb, std::uint32_t pc,
                                          const std::uint32_t* r, bool carry);

}  // namespace sim
