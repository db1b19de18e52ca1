// stack_growth.h - a stack that grows below the memory that it was in, or into the program's code
//
// Not handled: a stack that grows into data, or in a program without a section table.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

#include <fmt/format.h>

#include "sim/cpu/elf.h"

namespace sim {

class StackGrowth {
public:
    // After each quantum: where it is now.
    void follow(std::uint32_t sp) {
        const std::uint32_t moved = sp > now_ ? sp - now_ : now_ - sp;
        top_ = moved > JUMP ? sp : std::max(top_, sp);
        now_ = sp;
    }

    // What is wrong with it, or "".  `lowest`: the lowest address that was written, or was about to
    // be.  `through`: it may have passed the code already, and have overwritten it.
    template <class Core>
    std::string overflow(const Core& core, const ElfProgram& elf, std::uint32_t sp,
                         std::uint32_t lowest, bool through) const {
        if (top_ == 0 || now_ - lowest > JUMP) return "";  // it has not grown since it was seen
        std::uint8_t byte;
        if (core.read_ram(now_, &byte, 1) && !core.read_ram(lowest, &byte, 1))
            return fmt::format("the stack has grown below its memory (SP 0x{:08X})", sp);
        for (const ElfSection& section : elf.sections) {
            const std::uint32_t end = section.address + section.size;
            if (section.executable && top_ > end && lowest < end &&
                (through || lowest >= section.address))
                return fmt::format("the stack has grown into the program's code (SP 0x{:08X})", sp);
        }
        return "";
    }

private:
    // Bytes.  A stack pointer that has moved farther was assigned, and has not grown: it is more
    // than a quantum's instructions can push.
    static constexpr std::uint32_t JUMP = 1 << 20;

    std::uint32_t top_ = 0, now_ = 0;  // its highest value seen, its present one
};

}  // namespace sim
