// arm_runaway.h - programs whose PC or stack is where it cannot belong
//
// Some errors cause no exception.  So a program has also failed
//   - when it went into the data of its ELF (ElfSection::is_data), and there takes an abort or an
//     undefined instruction, or stands still on a word that it has not written;
//   - when its stack grows below the memory that it was in, or into its code; this is checked after
//     each quantum.
//
// Not handled: see stack_growth.h.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "sim/cpu/arm_core.h"
#include "sim/cpu/elf.h"
#include "sim/cpu/stack_growth.h"

namespace sim {

class ArmRunaway {
public:
    ArmRunaway(ArmCore& core, const ElfProgram& elf) : core_{core}, elf_{elf} {}

    // After a reset.
    void reset() {
        entered_data_.clear();
        stacks_ = {};
    }

    // Keeps instructions from being read from the ELF's data, until the program gets there.
    void forbid_data();
    // There is no instruction to be read because pc is in the ELF's data, for the first time: from
    // now on there is one, since the program may have written some.  `where` and `callers` are kept
    // for the message of a failure there.  False: that is not why.
    bool enters_data(const std::string& where, const std::string& callers);

    // What is wrong if pc is in the ELF's data while `what` happens, or nothing.
    std::optional<std::string> in_data(const std::string& what) const;

    // What is wrong with the present mode's stack, or "".  `lowest`: the lowest address that was
    // written, or was about to be.  `through`: the stack may have passed the code already, and have
    // overwritten it.
    std::string stack_overflow(std::uint32_t lowest, bool through) const;

    // After each quantum: what the program has done that it cannot have meant, or nothing.
    // `stands_still`: it loops on one instruction.
    std::optional<std::string> check(bool stands_still);

private:
    const ElfSection* data_at(std::uint32_t address) const;
    bool is_as_loaded(std::uint32_t address) const;

    ArmCore& core_;
    const ElfProgram& elf_;
    std::array<StackGrowth, 16> stacks_;  // of each mode, by CPSR[3:0]
    std::string entered_data_;            // where and by whom, while it is there
};

}  // namespace sim
