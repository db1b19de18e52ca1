#include "sim/cpu/arm_runaway.h"

#include <algorithm>

#include <fmt/format.h>

namespace sim {

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
    return stacks_[core_.cpsr() & 0xF].overflow(core_, elf_, core_.reg(13), lowest, through);
}

std::optional<std::string> ArmRunaway::check(bool stands_still) {
    if (!data_at(core_.pc()))
        entered_data_.clear();
    else if (stands_still && is_as_loaded(core_.pc()))
        return in_data("it stands still");
    const std::uint32_t sp = core_.reg(13);
    if (!stack_overflow(sp, false).empty()) return "the program ran out of stack";
    stacks_[core_.cpsr() & 0xF].follow(sp);
    return std::nullopt;
}

}  // namespace sim
