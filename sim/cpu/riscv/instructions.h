// instructions.h - RV32IMAF instructions as the interpreter executes them: decoded, a page at once
//
// A page is 4 KB of code: an Op for each word, then one that goes on to the next page, then one for
// each jump that leaves it.  So all branches are distances within one array.
//
// A run is a piece of code without a jump in it, up to the next jump, or to the page's end.  An Op
// knows what is left of its run from itself on, in instructions and in clocks: the interpreter
// counts where it enters a run, and takes back what it did not do where it leaves one early.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace sim {

// Clocks of an instruction, by class; memory answers within them.
struct RiscvClocks {
    std::uint16_t simple = 1, branch = 1, taken = 2, jump = 2, load = 1, store = 1, multiply = 1,
                  divide = 1, csr = 1, float_add = 1, float_multiply = 1, float_fused = 1,
                  float_divide = 1, float_root = 1, float_convert = 1, float_compare = 1,
                  float_choose = 1;
};

struct RiscvOp {
    enum Code : std::uint8_t {
#define RISCV_OP(name, clocks, ends) name,
#include "sim/cpu/riscv/instructions.def"
#undef RISCV_OP
    };
    // Register 0 as a destination: written, never read.
    static constexpr std::uint8_t NOWHERE = 32;

    Code code = ILLEGAL;
    std::uint8_t rd = 0, rs1 = 0, rs2 = 0;
    // The immediate; of a jump the distance in Ops; of FAR and MISALIGNED where it goes; of
    // floating point the rounding mode, and the third operand from bit 8 on.
    std::int32_t imm = 0;
    std::uint16_t run = 0, clocks = 0;  // from this one on

    // The clocks of this one alone.
    unsigned own_clocks() const { return run > 1 ? clocks - this[1].clocks : clocks; }
};

struct RiscvPage {
    static constexpr std::uint32_t BYTES = 4096, WORDS = BYTES / 4;

    std::uint32_t base = 0;
    std::uint64_t checked = 0;  // the generation in which `words` were last seen in memory
    std::array<std::uint32_t, WORDS> words{};
    std::vector<RiscvOp> ops;

    std::uint32_t pc_of(const RiscvOp* op) const {
        return base + static_cast<std::uint32_t>(op - ops.data()) * 4;
    }
};

// Decodes `page.words` for their place at `page.base`.
void decode(RiscvPage& page, const RiscvClocks& clocks);

}  // namespace sim
