// alignment.h - which unaligned loads and stores Linux's kernel does itself after the fault.
//
// LDM, STM, LDRD and STRD fault anywhere, LDR, LDRH and their like in what /dev/mem maps of
// devices.  By default the kernel then does them, a byte at a time (/proc/cpu/alignment: 2); all
// others end in SIGBUS.  Source: Linux, arch/arm/mm/alignment.c, do_alignment().
#pragma once

#include <cstdint>

namespace sim {

// `word`: the instruction; a Thumb one of 32 bits has its first halfword above, of 16 bits it is
// below 0x10000.
bool kernel_does_unaligned(std::uint32_t word, bool thumb);

}  // namespace sim
