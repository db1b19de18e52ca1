// missed_neon.h - NEON's instructions that dynarmic does not have, or rounds otherwise than ARMv7.
//
//   saturating.cpp  VQRSHL, VQADD and VQSUB of 64 bits, V(R)ADDHN, V(R)SUBHN, VQDMULL, VQDMLAL,
//                   VQDMLSL
//   steps.cpp       VRECPS, VRSQRTS
//
// They compute with registers alone.  Whether the program may use NEON is the caller's to check.
#pragma once

#include <array>
#include <cstdint>

namespace sim {

using VfpWords = std::array<std::uint32_t, 64>;  // d0 - d31, the lower word first

// Of the first group; `word` as in instructions.h.
bool is_missed_neon(std::uint32_t word, bool thumb);
// Does it; `saturated` is set if a result does not fit, and unchanged otherwise.  False: it is none
// of these.
bool missed_neon(std::uint32_t word, bool thumb, VfpWords& words, bool& saturated);

// Does a VRECPS or VRSQRTS (is_newton_step() in instructions.h); only the bits are read that ARM's
// encoding and Thumb's have in common.  False: it is undefined.
bool newton_step(std::uint32_t word, VfpWords& words);

}  // namespace sim
