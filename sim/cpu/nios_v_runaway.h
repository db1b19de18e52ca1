// nios_v_runaway.h - programs for Nios V whose PC, handler or stack is where it cannot belong
//
// Not handled: see stack_growth.h; code without a trap in the data of the ELF.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim/cpu/elf.h"
#include "sim/cpu/riscv/core.h"
#include "sim/cpu/stack_growth.h"

namespace sim {

class NiosVRunaway {
public:
    NiosVRunaway(const RiscvCore& core, const ElfProgram& elf) : core_{core}, elf_{elf} {}

    // The name of the ELF's section of data there, ".rodata", or "".
    std::string data_at(std::uint32_t address) const;
    // "which is data (.rodata)", of an address that cannot be code; or "".
    std::string no_code_at(std::uint32_t address) const;

    // What is wrong with the stack at a trap, perhaps of a store to this address; or "".
    std::string stack_at_trap(std::optional<std::uint32_t> stored) const;

    // After each quantum: what is wrong with the stack, or "".
    std::string check();

private:
    const RiscvCore& core_;
    const ElfProgram& elf_;
    StackGrowth stack_;
};

}  // namespace sim
