// registers.cpp - ArmCore's registers, and how they are after reset.
#include "sim/cpu/unicorn/engine.h"

namespace sim {

namespace {

constexpr int REGISTERS[] = {UC_ARM_REG_R0,  UC_ARM_REG_R1, UC_ARM_REG_R2,  UC_ARM_REG_R3,
                             UC_ARM_REG_R4,  UC_ARM_REG_R5, UC_ARM_REG_R6,  UC_ARM_REG_R7,
                             UC_ARM_REG_R8,  UC_ARM_REG_R9, UC_ARM_REG_R10, UC_ARM_REG_R11,
                             UC_ARM_REG_R12, UC_ARM_REG_SP, UC_ARM_REG_LR,  UC_ARM_REG_PC};

constexpr std::uint32_t FPEXC_EN = 1u << 30;
constexpr std::uint32_t BANK = 0;  // of CP15's two banks, the one that programs see

constexpr std::uint32_t SCR_NS = 1, SCR_FW = 1u << 4, SCR_AW = 1u << 5;

}  // namespace

void ArmCore::reset(std::uint32_t entry, std::uint32_t stack) {
    // Unicorn's core is in the Non-secure state, where it ignores changes of A and F without these
    // bits.
    set_cp15(cp15::SCR, SCR_NS | SCR_FW | SCR_AW);
    set_cpsr(arm_mode::SVC | arm_cpsr::A | arm_cpsr::I | arm_cpsr::F |
             (entry & 1 ? arm_cpsr::T : 0));
    set_cp15(cp15::SCTLR, 0x00C50078);
    set_cp15(cp15::VBAR, 0);
    set_cp15(cp15::CBAR, 0xFFFEC000);
    set_floating_point(false);
    for (unsigned number = 0; number < 15; ++number) set_reg(number, 0);
    set_reg(13, stack);
    set_reg(15, entry);
}

void ArmCore::clear_exclusive() {}

void ArmCore::set_floating_point(bool on) {
    set_cp15(cp15::CPACR, on ? 0x00F00000 : 0);
    const std::uint32_t enable = on ? FPEXC_EN : 0;
    check_uc(uc_reg_write(engine_->uc, UC_ARM_REG_FPEXC, &enable), "FPEXC");
}

bool ArmCore::floating_point() const {
    std::uint32_t fpexc = 0;
    uc_reg_read(engine_->uc, UC_ARM_REG_FPEXC, &fpexc);
    const std::uint32_t rights = cp15(cp15::CPACR) >> 20 & 3;
    const bool user = (cpsr() & arm_cpsr::MODE) == arm_mode::USR;
    return (fpexc & FPEXC_EN) && (rights == 3 || (rights == 1 && !user));
}

std::uint32_t ArmCore::reg(unsigned number) const {
    std::uint32_t value = 0;
    uc_reg_read(engine_->uc, REGISTERS[number & 15], &value);
    return value;
}

// Unicorn takes T from bit 0 of a written pc.
void ArmCore::set_reg(unsigned number, std::uint32_t value) {
    if (number == 15) value = (value & ~1u) | (cpsr() & arm_cpsr::T ? 1 : 0);
    uc_reg_write(engine_->uc, REGISTERS[number & 15], &value);
}

std::uint32_t ArmCore::cpsr() const {
    std::uint32_t value = 0;
    uc_reg_read(engine_->uc, UC_ARM_REG_CPSR, &value);
    return value;
}

void ArmCore::set_cpsr(std::uint32_t value) { uc_reg_write(engine_->uc, UC_ARM_REG_CPSR, &value); }

std::uint32_t ArmCore::spsr() const {
    std::uint32_t value = 0;
    uc_reg_read(engine_->uc, UC_ARM_REG_SPSR, &value);
    return value;
}

void ArmCore::set_spsr(std::uint32_t value) { uc_reg_write(engine_->uc, UC_ARM_REG_SPSR, &value); }

std::uint64_t ArmCore::vfp(unsigned number) const {
    std::uint64_t value = 0;
    uc_reg_read(engine_->uc, UC_ARM_REG_D0 + static_cast<int>(number & 31), &value);
    return value;
}

void ArmCore::set_vfp(unsigned number, std::uint64_t value) {
    uc_reg_write(engine_->uc, UC_ARM_REG_D0 + static_cast<int>(number & 31), &value);
}

std::uint32_t ArmCore::fpscr() const {
    std::uint32_t value = 0;
    uc_reg_read(engine_->uc, UC_ARM_REG_FPSCR, &value);
    return value;
}

void ArmCore::set_fpscr(std::uint32_t value) {
    uc_reg_write(engine_->uc, UC_ARM_REG_FPSCR, &value);
}

std::uint32_t ArmCore::cp15(const Cp15& name) const {
    uc_arm_cp_reg reg{15, 0, BANK, name.crn, name.crm, name.op1, name.op2, 0};
    check_uc(uc_reg_read(engine_->uc, UC_ARM_REG_CP_REG, &reg), "CP15");
    return static_cast<std::uint32_t>(reg.val);
}

void ArmCore::set_cp15(const Cp15& name, std::uint32_t value) {
    uc_arm_cp_reg reg{15, 0, BANK, name.crn, name.crm, name.op1, name.op2, value};
    check_uc(uc_reg_write(engine_->uc, UC_ARM_REG_CP_REG, &reg), "CP15");
}

std::optional<std::uint32_t> ArmCore::code_at(std::uint32_t, bool) { return {}; }
std::optional<ArmCore::Cycles> ArmCore::cycles() const { return {}; }
ArmCore::Place ArmCore::place(std::uint32_t, bool) { return {}; }
void ArmCore::store_word(std::uint32_t, std::uint32_t) {}

}  // namespace sim
