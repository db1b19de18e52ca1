#include "sim/cpu/nios_v_runaway.h"

namespace sim {

static constexpr unsigned STACK_POINTER = 2;

std::string NiosVRunaway::data_at(std::uint32_t address) const {
    for (const ElfSection& section : elf_.sections)
        if (section.is_data() && section.holds(address)) return section.name;
    return "";
}

std::string NiosVRunaway::no_code_at(std::uint32_t address) const {
    if (const std::string data = data_at(address); !data.empty())
        return "which is data (" + data + ")";
    std::uint32_t word = 0;
    if (!core_.read_ram(address, &word, sizeof word)) return "where no memory is";
    return word == 0 ? "where there are only zeros" : "";
}

std::string NiosVRunaway::stack_at_trap(std::optional<std::uint32_t> stored) const {
    constexpr std::uint32_t FRAME = 4096;  // bytes of a function's frame, at most
    const std::uint32_t sp = core_.reg(STACK_POINTER);
    const bool of_stack = stored && *stored - sp < FRAME;
    if (of_stack && sp > UINT32_MAX - FRAME)
        return fmt::format(
            "SP is 0x{:08X}: it was never set, or the stack has grown past address 0", sp);
    return stack_.overflow(core_, elf_, sp, of_stack ? *stored : sp, true);
}

std::string NiosVRunaway::check() {
    const std::uint32_t sp = core_.reg(STACK_POINTER);
    std::string wrong = stack_.overflow(core_, elf_, sp, sp, false);
    if (wrong.empty()) stack_.follow(sp);
    return wrong;
}

}  // namespace sim
