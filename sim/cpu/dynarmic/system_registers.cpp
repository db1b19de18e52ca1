#include "sim/cpu/dynarmic/system_registers.h"

namespace sim {

namespace {

constexpr std::uint32_t FPEXC_EN = 1u << 30;

}  // namespace

void SystemRegisters::set_cpsr(std::uint32_t value) {
    const std::uint32_t was = cpu_.mode(), is = value & arm_cpsr::MODE;
    if (was != is) {
        cpu_.banked.change(cpu_.r(), was, is);
        cpu_.jit->ClearExclusiveState();
        const bool other_rights = (was == arm_mode::USR) != (is == arm_mode::USR);
        if (other_rights && (cpu_.cp15.value(cp15::SCTLR) & SCTLR_M)) mmu_.forget();
        if (is == arm_mode::USR) translated_.forget_privileged();
        if (other_rights && cpu_.floating_point_rights() == 1) translated_.forget_mappings();
    }
    if (cpu_.cpsr() & ~value & (arm_cpsr::A | arm_cpsr::I | arm_cpsr::F)) bus_.unmasked();
    cpu_.jit->SetCpsr(value);
}

void SystemRegisters::set_fpexc(std::uint32_t value) {
    const bool was = cpu_.floating_point();
    cpu_.fpexc = value & 0xE0000000;
    if (was != cpu_.floating_point()) translated_.forget_mappings();
}

void SystemRegisters::set_floating_point(bool on) {
    cpu_.cp15.set(cp15::CPACR, on ? 0x00F00000 : 0);
    cpu_.fpexc = on ? FPEXC_EN : 0;
    translated_.forget_mappings();
}

bool SystemRegisters::write(const Cp15& name, std::uint32_t value, std::uint64_t instructions) {
    if (name.crn == 7 && name.op1 == 0 && name.crm == 8) return translate_address(name, value);
    const auto effect = cpu_.cp15.write(name, value, cpu_.privileged(), instructions);
    if (!effect) return false;
    if (*effect != Cp15Registers::Effect::NONE) translated_.forget_mappings();
    return true;
}

// For a reader or writer, privileged or user.  The Non-secure state has its MMU off.
bool SystemRegisters::translate_address(const Cp15& name, std::uint32_t address) {
    if (!cpu_.privileged()) return false;
    const bool other_state = name.op2 & 4, user = name.op2 & 2;
    const Translation to = other_state
                               ? Translation{address, arm_access::ALL, 0, false, 1u << 4 | 1u << 9}
                               : mmu_.walk(address, !user);
    cpu_.cp15.set(cp15::PAR, par(to, name.op2 & 1 ? arm_access::WRITE : arm_access::READ));
    return true;
}

}  // namespace sim
