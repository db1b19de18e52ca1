// system_instructions.h - the instructions that dynarmic does not have: above all those of an
// operating system (ARM DDI 0406C, B9), because it only executes programs of the user mode.
//
//   system_instructions.cpp  status registers, modes, exception returns, coprocessors
//   system_transfers.cpp     loads and stores
//   missed_neon.h            NEON
//
// Where the program has one of them (is_system() in instructions.h), dynarmic reads an undefined
// instruction; the engine then calls execute().
#pragma once

#include <cstdint>
#include <optional>

#include "sim/cpu/arm_core.h"
#include "sim/cpu/dynarmic/cpu_state.h"
#include "sim/cpu/dynarmic/data_access.h"
#include "sim/cpu/dynarmic/mmu.h"
#include "sim/cpu/dynarmic/system_registers.h"

namespace sim {

class SystemInstructions {
public:
    // `core`: for its count of instructions.
    SystemInstructions(CpuState& cpu, SystemRegisters& registers, const Mmu& mmu, DataAccess& data,
                       const ArmCore& core)
        : cpu_{cpu}, registers_{registers}, mmu_{mmu}, data_{data}, core_{core} {}

    // The instruction at `pc`, `word` (instructions.h), unless its condition skips it.
    // False, and nothing is changed: it is undefined, or one of its accesses is not done, as
    // DataAccess says then.  Not while dynarmic runs.
    bool execute(std::uint32_t pc, std::uint32_t word, bool in_thumb);

private:
    bool arm(std::uint32_t word);
    bool thumb(std::uint32_t word);
    bool status(std::uint32_t word);
    void write_status(bool saved, unsigned mask, std::uint32_t value);
    void change_state(unsigned imod, bool change_mode, std::uint32_t masks, std::uint32_t mode);
    bool exception_return(std::uint32_t word);
    bool coprocessor(std::uint32_t word);
    bool neon(std::uint32_t word, bool in_thumb);

    bool return_from(std::uint32_t base, bool up, bool before, std::optional<unsigned> write_back);
    bool save_return(std::uint32_t mode, bool up, bool before, bool write_back);
    bool load_with_base(unsigned base, unsigned list, bool up, bool before);
    bool load_store_multiple(std::uint32_t word);

    bool unprivileged(std::uint32_t word, bool in_thumb);
    bool swap(std::uint32_t word);

    CpuState& cpu_;
    SystemRegisters& registers_;
    const Mmu& mmu_;
    DataAccess& data_;
    const ArmCore& core_;
};

}  // namespace sim
