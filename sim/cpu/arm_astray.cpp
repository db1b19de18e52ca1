// arm_astray.cpp - ArmCpu's detection of programs whose pc or stack has gone where it cannot belong
#include <algorithm>

#include <fmt/format.h>

#include "sim/cpu/arm_cpu.h"

namespace sim {

namespace {

// A stack pointer that has moved farther than this was assigned, and has not grown: it is more than
// a quantum's instructions can push.  In bytes.
constexpr std::uint32_t JUMP = 1 << 20;

}  // namespace

void ArmCpu::lost(const std::string& what) {
    const std::string stack = overgrown(core_.reg(13), true);
    const std::string why =
        fmt::format("{} {}; {}LR 0x{:08X}{}", what, where(), stack.empty() ? "" : stack + "; ",
                    core_.reg(14), callers());
    if (!inspector_ || !inspector_->on_failure(core_, ArmException::UNDEFINED)) fail(why);
}

const ElfSection* ArmCpu::data_at(std::uint32_t address) const {
    for (const ElfSection& section : program_.elf.sections)
        if (section.is_data() && section.holds(address)) return &section;
    return nullptr;
}

// What is wrong with the present mode's stack, or "".  `lowest`: the lowest address that was
// written, or was about to be.  `through`: the stack may have passed the code already, and have
// overwritten it.
std::string ArmCpu::overgrown(std::uint32_t lowest, bool through) const {
    const Stack& stack = stacks_[core_.cpsr() & 0xF];
    if (stack.top == 0 || stack.now - lowest > JUMP)
        return "";  // it has not grown since it was first seen
    std::uint8_t byte;
    if (core_.read_ram(stack.now, &byte, 1) && !core_.read_ram(lowest, &byte, 1))
        return fmt::format("the stack has grown below its memory (SP 0x{:08X})", core_.reg(13));
    for (const ElfSection& section : program_.elf.sections) {
        const std::uint32_t end = section.address + section.size;
        if (section.executable && stack.top > end && lowest < end &&
            (through || lowest >= section.address))
            return fmt::format("the stack has grown into the program's code (SP 0x{:08X})",
                               core_.reg(13));
    }
    return "";
}

// Called after each quantum.
void ArmCpu::look_astray() {
    if (kernel_ || fault()) return;
    if (const ElfSection* data = data_at(core_.pc()))
        return lost("the program went into its data, " + data->name + ",");
    const std::uint32_t sp = core_.reg(13);
    if (!overgrown(sp, false).empty()) return lost("the program ran out of stack");
    Stack& stack = stacks_[core_.cpsr() & 0xF];
    const std::uint32_t moved = sp > stack.now ? sp - stack.now : stack.now - sp;
    stack.top = moved > JUMP ? sp : std::max(stack.top, sp);
    stack.now = sp;
}

}  // namespace sim
