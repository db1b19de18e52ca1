// arm_callers.cpp - who called a program's last function, as far as its stack shows
#include <array>
#include <cstring>

#include "sim/cpu/arm_cpu.h"

namespace sim {

namespace {

constexpr unsigned WORDS = 256, MOST = 5;  // words of the stack that are examined; names

// The instruction before `address` is a BL or BLX, by the encodings of ARM DDI 0406C, A8.8.25 - 26.
bool is_behind_a_call(const ArmCore& core, std::uint32_t address) {
    if (address & 1) {
        std::array<std::uint16_t, 2> halves{};
        if (!core.read_ram(address - 5, halves.data(), 4)) return false;
        const bool wide = (halves[0] & 0xF800) == 0xF000 && (halves[1] & 0xC000) == 0xC000;
        return wide || (halves[1] & 0xFF87) == 0x4780;
    }
    std::uint32_t word = 0;
    if (address % 4 != 0 || !core.read_ram(address - 4, &word, 4)) return false;
    const bool always = word >> 28 == 0xF;
    return (always && (word & 0x0E000000) == 0x0A000000) ||
           (!always && ((word & 0x0F000000) == 0x0B000000 || (word & 0x0FFFFFF0) == 0x012FFF30));
}

}  // namespace

std::string ArmCpu::callers() const {
    std::string text;
    std::uint32_t last = 0;
    unsigned names = 0;
    const auto add = [&](std::uint32_t address) {
        if (names == MOST || address == last || !is_behind_a_call(core_, address)) return;
        const std::string name = program_.elf.function((address & ~1u) - 1);
        if (name.empty()) return;
        last = address;
        text += (names++ == 0 ? "; called from " : ", ") + name.substr(0, name.find("+0x"));
    };
    add(core_.reg(14));
    for (unsigned i = 0; i < WORDS && names < MOST; ++i) {
        std::uint32_t word = 0;
        if (!core_.read_ram(core_.reg(13) + 4 * i, &word, 4)) break;
        add(word);
    }
    return text;
}

}  // namespace sim
