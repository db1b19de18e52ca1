// transferred_words.h - how many words an instruction of ARM or Thumb loads or stores, at rising
// addresses, and whether exclusively (ARM DDI 0406C)
#pragma once

#include <cstdint>

namespace sim {

// Of LDM, LDRD, VLDM, VLD1 of words and their like; 1 of all others, also of one that loads or
// stores nothing.  A Thumb instruction of 16 bits has bits 31:16 clear.
unsigned transferred_words(std::uint32_t instruction, bool thumb);

// LDREX, STREX and their like.
bool is_exclusive(std::uint32_t instruction, bool thumb);

}  // namespace sim
