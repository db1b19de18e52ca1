// instructions.h - the ARM and Thumb encodings that the engine treats specially (ARM DDI 0406C).
//
// An instruction is `word`; a Thumb one of 16 bits has its bits 31:16 clear, one of 32 bits has
// its first halfword there.
#pragma once

#include <cstdint>
#include <optional>

namespace sim {

// Whether `word` has these bits where `mask` has ones.
constexpr bool is(std::uint32_t word, std::uint32_t mask, std::uint32_t value) {
    return (word & mask) == value;
}
// How many ones: of an LDM's list, its registers.
constexpr unsigned bits_of(std::uint32_t word) {
    unsigned count = 0;
    for (; word != 0; word &= word - 1) ++count;
    return count;
}

inline unsigned thumb_bytes(std::uint16_t first) { return first < 0xE800 ? 2 : 4; }

// Dynarmic does not execute it, or does so wrongly: system_instructions.h has it.
// `floating_point`: the program may use VFP and NEON.
bool is_system(std::uint32_t word, bool thumb, bool floating_point);

// The Cortex-A9 has no such instruction, or dynarmic misses it: it is undefined.  Given to
// dynarmic, it could be taken for another instruction, or end the process.
bool is_absent(std::uint32_t word, bool thumb);

// A branch, after which translated code checks how many instructions are left.  Some instructions
// that branch by other means are not recognised.
bool is_branch(std::uint32_t word, bool thumb);

// Where the program may go on, other than after the instruction at `pc`: whether by a call, and the
// target if it is known.  TBB and TBH are left out.
struct Departure {
    bool call;
    std::optional<std::uint32_t> target;
};
std::optional<Departure> departure(std::uint32_t word, bool thumb, std::uint32_t pc);

// For some loads and stores dynarmic changes the base register before the access.  If `word` is one
// of them: that register, and the value added to it.  `r`: r0 - r15 as after the change; `address`:
// of the access.
struct WriteBack {
    unsigned base;
    std::uint32_t added;
};
std::optional<WriteBack> early_write_back(std::uint32_t word, bool thumb, const std::uint32_t* r,
                                          bool carry, std::uint32_t address);

// LDM with its base in the list and without write-back.  Dynarmic would lose the base if a later
// access has to be repeated.
bool loads_its_base(std::uint32_t word, bool thumb);
// VRECPS and VRSQRTS.
bool is_newton_step(std::uint32_t word, bool thumb);
// LDRT, STRT and their kind; SWP and SWPB of ARM.
bool is_unprivileged(std::uint32_t word, bool thumb);
bool is_swap(std::uint32_t word);

// ---- IT blocks: CPSR's IT[7:0] in one piece ----

bool is_it(std::uint32_t word);
unsigned it_state(std::uint32_t cpsr);
std::uint32_t with_it_state(std::uint32_t cpsr, unsigned it);
unsigned next_it(unsigned it);  // for the next instruction

// ---- Computing ----

// A shift by an immediate or register amount; `carry` goes in and comes out.
std::uint32_t shifted(std::uint32_t value, unsigned type, unsigned amount, bool by_register,
                      bool& carry);

// Condition `cond` (0 - 15) with these flags.
bool condition_holds(unsigned cond, std::uint32_t cpsr);

}  // namespace sim
