// code_reader.h - the program's code as dynarmic reads it to translate it: from where, how far, and
// what is replaced.
//
// Dynarmic reads a block's words from r15 on (a Thumb instruction of 32 bits may lie in two words),
// and asks for the ticks of each instruction.  Without a word it ends the block before that
// instruction, and raises NoExecuteFault there.
//
//   the program has                                dynarmic reads
//   what is_system() (instructions.h)              UDF, which SystemInstructions executes
//   a single access, marked as one of the bus      SVC #n; n of its block's instructions are before
//   VLD1 :64 and the like                          the same as doublewords (alignment.h)
//   the begin of another block or function,        a branch there, which is not counted
//   or the 65th instruction of a block
//   other marked accesses, a place for a probe,    nothing
//   no code
//
// Only the first and the third are replaced for a step.  Blocks do not overlap, so each instruction
// belongs to one known block.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/cpu/dynarmic/cpu_state.h"
#include "sim/cpu/dynarmic/inspectors.h"
#include "sim/cpu/dynarmic/mmu.h"
#include "sim/cpu/dynarmic/translated_code.h"

namespace sim {

class CodeReader {
public:
    // For the tally, an instruction that may leave a function costs so many ticks more than any run
    // has left, so the run ends after its block.  The values also say which kind it was.
    static constexpr std::uint64_t CALL = 1u << 24, JUMP = 2u << 24, TALLIED = CALL - 1;

    CodeReader(CpuState& cpu, Mmu& mmu, TranslatedCode& translated, const Inspectors& inspectors)
        : cpu_{cpu}, mmu_{mmu}, translated_{translated}, inspectors_{inspectors} {}

    // ---- What for ----

    // Translated code, with room for so many instructions without a branch at the end of its count.
    void begin_run(unsigned left_over);
    void begin_step();

    // ---- What dynarmic asks ----

    std::optional<std::uint32_t> word(std::uint32_t address);
    // Of the instruction `word` at `pc`, which is the next of its block from now on.
    std::uint64_t ticks(bool thumb, std::uint32_t pc, std::uint32_t word);
    // The word at an address that is known at translation, that is a literal in the code, may
    // become a constant.
    bool is_constant(std::uint32_t address);

    // ---- What is known then ----

    // Instructions without a branch, of the longest that have been translated.
    unsigned longest() const { return longest_; }
    // The present run was to translate more of them than it leaves room for.  What is translated
    // there is to be dropped.
    bool has_no_room() const { return no_room_; }

private:
    struct Block {
        std::uint32_t begin = 1, next = 1;  // `next`: of the instruction to be read
        bool thumb = false;
        unsigned instructions = 0;  // read so far
        unsigned it = 0;            // state of the IT block for the next one
        bool linked = false;        // ends before the begin of another one, or of a function
    };

    bool begin_instruction(std::uint32_t address);
    bool becomes_link();
    bool becomes_call();
    bool is_single_access() const;
    std::optional<std::uint32_t> program_word(std::uint32_t address);
    std::optional<std::uint32_t> replaced(std::uint32_t instruction);
    std::uint32_t with_half(std::uint32_t word, std::uint32_t half) const;
    std::uint64_t ticks_of_departure(bool thumb, std::uint32_t pc, std::uint32_t word) const;

    CpuState& cpu_;
    Mmu& mmu_;
    TranslatedCode& translated_;
    const Inspectors& inspectors_;

    bool stepping_ = false;
    unsigned left_over_ = 0;
    unsigned longest_ = 32;
    bool no_room_ = false;
    Block block_;
};

}  // namespace sim
