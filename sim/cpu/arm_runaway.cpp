#include "sim/cpu/arm_runaway.h"

#include <algorithm>

#include <fmt/format.h>

namespace sim {

namespace {

// A stack pointer that has moved farther than this was assigned, and has not grown: it is more than
// a quantum's instructions can push.  In bytes.
constexpr std::uint32_t JUMP = 1 << 20;

}  // namespace

const ElfSection* ArmRunaway::data_at(std::uint32_t address) const {
    for (const ElfSection& section : elf_.sections)
        if (section.is_data() && section.holds(address)) return &section;
    return nullptr;
}

void ArmRunaway::forbid_data() {
    for (const ElfSection& section : elf_.sections)
        if (section.is_data()) core_.forbid_code(section.address, section.size);
}

bool ArmRunaway::enters_data(const std::string& where, const std::string& callers) {
    const std::uint32_t pc = core_.fault().address;
    const ElfSection* const data = data_at(pc);
    std::uint16_t half = 0;
    if (!data || core_.fault().mmu || !core_.read_ram(pc, &half, sizeof half)) return false;
    for (const ElfSection& section : elf_.sections)
        if (section.is_data()) core_.permit_code(section.address, section.size);
    entered_data_ = fmt::format("the program went into its data, {}, {}; LR 0x{:08X}{}", data->name,
                                where, core_.reg(14), callers);
    return true;
}

std::optional<std::string> ArmRunaway::in_data(const std::string& what) const {
    const ElfSection* const data = data_at(core_.pc());
    if (!data) return std::nullopt;
    if (!entered_data_.empty()) return entered_data_ + "; there: " + what;
    return fmt::format("the program is in its data, {}: {}", data->name, what);
}

// The program has not written this word.
bool ArmRunaway::is_as_loaded(std::uint32_t address) const {
    std::array<std::uint8_t, 4> now{};
    if (!core_.read_ram(address, now.data(), now.size())) return false;
    for (const ElfSegment& segment : elf_.segments) {
        const std::uint32_t offset = address - segment.physical;
        if (offset < segment.data.size() && segment.data.size() - offset >= now.size())
            return std::equal(now.begin(), now.end(), segment.data.begin() + offset);
    }
    return false;
}

std::string ArmRunaway::stack_overflow(std::uint32_t lowest, bool through) const {
    const Stack& stack = stacks_[core_.cpsr() & 0xF];
    if (stack.top == 0 || stack.now - lowest > JUMP)
        return "";  // it has not grown since it was first seen
    std::uint8_t byte;
    if (core_.read_ram(stack.now, &byte, 1) && !core_.read_ram(lowest, &byte, 1))
        return fmt::format("the stack has grown below its memory (SP 0x{:08X})", core_.reg(13));
    for (const ElfSection& section : elf_.sections) {
        const std::uint32_t end = section.address + section.size;
        if (section.executable && stack.top > end && lowest < end &&
            (through || lowest >= section.address))
            return fmt::format("the stack has grown into the program's code (SP 0x{:08X})",
                               core_.reg(13));
    }
    return "";
}

std::optional<std::string> ArmRunaway::check(bool stands_still) {
    if (!data_at(core_.pc()))
        entered_data_.clear();
    else if (stands_still && is_as_loaded(core_.pc()))
        return in_data("it stands still");
    const std::uint32_t sp = core_.reg(13);
    if (!stack_overflow(sp, false).empty()) return "the program ran out of stack";
    Stack& stack = stacks_[core_.cpsr() & 0xF];
    const std::uint32_t moved = sp > stack.now ? sp - stack.now : stack.now - sp;
    stack.top = moved > JUMP ? sp : std::max(stack.top, sp);
    stack.now = sp;
    return std::nullopt;
}

}  // namespace sim
