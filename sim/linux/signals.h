// signals.h - a Linux process's signals: their actions, and a handler's frame.
//
// Source: Linux 6.1, arch/arm/kernel/signal.c: struct sigframe, rt_sigframe, sigcontext.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "sim/cpu/arm_core.h"
#include "sim/linux/address_space.h"

namespace sim {

class LinuxSignals {
public:
    static constexpr unsigned COUNT = 64;  // numbered from 1

    struct Action {                                          // as the kernel's struct sigaction
        std::uint32_t handler = 0, flags = 0, restorer = 0;  // handler 0: default, 1: ignored
        std::uint64_t mask = 0;
    };
    std::array<Action, COUNT + 1> actions{};
    std::uint64_t blocked = 0, pending = 0;   // bit n: signal n + 1
    std::uint32_t stack = 0, stack_size = 0;  // of sigaltstack

    static constexpr std::uint64_t bit(unsigned number) { return std::uint64_t{1} << (number - 1); }
    static bool ignored_by_default(unsigned number);
    static const char* name(unsigned number);  // "SIGSEGV"

    // The pending signal to deliver next.
    std::optional<unsigned> next() const;

    // Writes the frame to the program's stack and jumps to the handler; false: no room there.
    bool enter(ArmCore& core, AddressSpace& memory, unsigned number, std::uint32_t address);
    // Returns from it; `rt`: the kind of frame.  False: the frame cannot be read.
    bool leave(ArmCore& core, const AddressSpace& memory, bool rt);
};

}  // namespace sim
