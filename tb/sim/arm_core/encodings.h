// encodings.h - tables of ARM and Thumb encodings, from which random instructions are made.
//
// A row's bits are 16 or 32 characters, the highest bit first.  A character stands for a field's
// bits, which need not be together:
//
//   0 1    as they are           x      any
//   c      condition             d e    two different registers to write; e is not d
//   r      an even register of a pair to write      o      an even register of a pair to read
//   n m s a  registers to read, not pc              N M    registers to read, pc too
//   p      base register whose value is a multiple of 4     q  base register of any value
//   i      index register, small        k   index register, small << 22
//   l      list of registers to write   L   list of registers to read
//
// Source: ARM DDI 0406C, A5 - A8.  No row makes an UNPREDICTABLE instruction, nor one that the
// Cortex-A9 does not have.
#pragma once

#include <cstdint>
#include <vector>

namespace tb::core {

struct Encoding {
    const char* name;
    const char* bits;
    bool (*allowed)(std::uint32_t word) = nullptr;
};

const std::vector<Encoding>& arm_encodings();
const std::vector<Encoding>& arm_memory_encodings();
const std::vector<Encoding>& thumb_encodings();
const std::vector<Encoding>& thumb_memory_encodings();
// Both as ARM encodings; to_thumb() makes Thumb ones of them.
const std::vector<Encoding>& vfp_encodings();
const std::vector<Encoding>& neon_encodings();
const std::vector<Encoding>& neon_memory_encodings();
std::uint32_t to_thumb(std::uint32_t vfp_or_neon);

constexpr std::uint32_t field(std::uint32_t word, unsigned high, unsigned low) {
    return word >> low & ((2u << (high - low)) - 1);
}
constexpr bool bit(std::uint32_t word, unsigned number) { return word >> number & 1; }

}  // namespace tb::core
