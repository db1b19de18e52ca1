// system_registers.h - the registers of an operating system, and what else a write of them changes.
//
// A new mode has other banked registers and other rights; new translation tables and new rights
// have other code; the bus is notified when an interrupt is unmasked.
#pragma once

#include <cstdint>
#include <optional>

#include "sim/cpu/arm_core.h"
#include "sim/cpu/dynarmic/cpu_state.h"
#include "sim/cpu/dynarmic/mmu.h"
#include "sim/cpu/dynarmic/translated_code.h"

namespace sim {

class SystemRegisters {
public:
    SystemRegisters(CpuState& cpu, Mmu& mmu, TranslatedCode& translated, ArmBus& bus)
        : cpu_{cpu}, mmu_{mmu}, translated_{translated}, bus_{bus} {}

    void set_cpsr(std::uint32_t value);
    void set_fpexc(std::uint32_t value);
    // CPACR and FPEXC.EN.
    void set_floating_point(bool on);
    // As MRC and MCR do in the present mode.  Nothing, and false: the instruction is undefined.
    // `instructions`: so far.
    std::optional<std::uint32_t> read(const Cp15& name, std::uint64_t instructions) const {
        return cpu_.cp15.read(name, cpu_.privileged(), instructions);
    }
    bool write(const Cp15& name, std::uint32_t value, std::uint64_t instructions);

private:
    bool translate_address(const Cp15& name, std::uint32_t address);

    CpuState& cpu_;
    Mmu& mmu_;
    TranslatedCode& translated_;
    ArmBus& bus_;
};

}  // namespace sim
