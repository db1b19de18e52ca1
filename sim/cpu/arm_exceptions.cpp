#include "sim/cpu/arm_exceptions.h"

namespace sim {

namespace {

namespace sctlr {
constexpr std::uint32_t V = 1u << 13, EE = 1u << 25, TE = 1u << 30;
}

struct Entry {
    std::uint32_t offset, mode, masks;
    std::uint32_t arm_return, thumb_return;  // r14 - pc
};

Entry entry_of(ArmException exception) {
    using namespace arm_cpsr;
    switch (exception) {
        case ArmException::UNDEFINED: return {0x04, arm_mode::UND, I, 4, 2};
        case ArmException::SVC: return {0x08, arm_mode::SVC, I, 0, 0};
        case ArmException::PREFETCH_ABORT: return {0x0C, arm_mode::ABT, I | A, 4, 4};
        case ArmException::DATA_ABORT:
        case ArmException::ASYNCHRONOUS_ABORT: return {0x10, arm_mode::ABT, I | A, 8, 8};
        case ArmException::IRQ: return {0x18, arm_mode::IRQ, I | A, 4, 4};
        case ArmException::FIQ: break;
    }
    return {0x1C, arm_mode::FIQ, I | A | F, 4, 4};
}

}  // namespace

std::uint32_t vector_of(const ArmCore& core, ArmException exception) {
    const std::uint32_t base =
        core.cp15(cp15::SCTLR) & sctlr::V ? 0xFFFF0000 : core.cp15(cp15::VBAR) & ~0x1fu;
    return base + entry_of(exception).offset;
}

bool is_semihosting(const ArmCore& core) {
    const bool thumb = core.cpsr() & arm_cpsr::T;
    const std::uint32_t size = thumb ? 2 : 4, request = thumb ? 0xDFAB : 0xEF123456;
    std::uint32_t instruction = 0;
    return core.read_ram(core.pc() - size, &instruction, size) && instruction == request;
}

void enter(ArmCore& core, ArmException exception, std::uint32_t status, std::uint32_t address) {
    const Entry entry = entry_of(exception);
    const std::uint32_t was = core.cpsr(), control = core.cp15(cp15::SCTLR);
    const std::uint32_t link =
        core.pc() + (was & arm_cpsr::T ? entry.thumb_return : entry.arm_return);
    if (exception == ArmException::ASYNCHRONOUS_ABORT) {
        core.set_cp15(cp15::DFSR, status);
    } else if (exception == ArmException::DATA_ABORT) {
        core.set_cp15(cp15::DFSR, status);
        core.set_cp15(cp15::DFAR, address);
    } else if (exception == ArmException::PREFETCH_ABORT) {
        core.set_cp15(cp15::IFSR, status);
        core.set_cp15(cp15::IFAR, address);
    }
    using namespace arm_cpsr;
    std::uint32_t now = (was & ~(MODE | T | J | E | IT)) | entry.mode | entry.masks;
    if (control & sctlr::TE) now |= T;
    if (control & sctlr::EE) now |= E;
    const std::uint32_t vector = vector_of(core, exception);
    core.set_cpsr(now);
    core.set_spsr(was);
    core.set_reg(14, link);
    core.set_reg(15, vector);
}

}  // namespace sim
