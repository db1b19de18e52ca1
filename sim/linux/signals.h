// signals.h - a Linux process's signals: their actions, what is pending, and a handler's frame.
//
// Source: Linux 6.1, arch/arm/kernel/signal.c: struct sigframe, rt_sigframe, sigcontext,
// vfp_sigframe.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "sim/cpu/arm_core.h"
#include "sim/linux/address_space.h"

namespace sim {

// As in siginfo_t, and in words for the run's messages.
struct LinuxSignal {
    unsigned number = 0;
    std::int32_t code = 0;
    // An address; or process, user, value or status, ticks of a child.
    std::array<std::uint32_t, 4> fields{};
    std::string why{};  // "sent by itself"
    // By which number of timer_create's, and in which of the times that it was sent or set.
    struct {
        int number = -1;
        std::uint32_t sequence = 0;
    } timer{};
    bool by_hand = false;  // from outside of the program
};

namespace arm_signal_code {
constexpr std::int32_t USER = 0, KERNEL = 0x80, QUEUE = -1, TIMER = -2, MESSAGE = -3, TKILL = -6;
// Of faults: SIGSEGV, SIGBUS, SIGILL, SIGTRAP.
constexpr std::int32_t NOT_MAPPED = 1, NOT_ALLOWED = 2;
constexpr std::int32_t EXTERNAL_ABORT = 0, MISALIGNED = 1, AFTER_FILE = 2;
constexpr std::int32_t ILLEGAL_OPCODE = 1, BREAKPOINT = 1;
}  // namespace arm_signal_code

class LinuxSignals {
public:
    static constexpr unsigned COUNT = 64, FIRST_REAL_TIME = 32;  // numbered from 1

    struct Action {                                          // as the kernel's struct sigaction
        std::uint32_t handler = 0, flags = 0, restorer = 0;  // handler 0: default, 1: ignored
        std::uint64_t mask = 0;
        bool handled() const { return handler > 1; }
    };
    std::array<Action, COUNT + 1> actions{};

    static constexpr std::uint64_t bit(unsigned number) { return std::uint64_t{1} << (number - 1); }
    static bool ignored_by_default(unsigned number);
    static bool stops_by_default(unsigned number);
    static const char* name(unsigned number);  // "SIGSEGV"
    bool ignores(unsigned number) const {
        const std::uint32_t handler = actions[number].handler;
        return handler == 1 || (handler == 0 && ignored_by_default(number));
    }
};

// Of a thread or a process.  One of a number below 32 is kept once, others in their order; a timer
// has one of its own.
class PendingSignals {
public:
    bool add(const LinuxSignal& signal);  // false: there are too many
    std::uint64_t set() const;
    // The one of the lowest number that is not among `blocked`.
    std::optional<LinuxSignal> dequeue(std::uint64_t blocked);
    void remove(std::uint64_t set);
    LinuxSignal* of_timer(int number);              // nullptr: it has none here
    void remove_timers();                           // those that timers have sent
    std::uint64_t added() const { return added_; }  // so far

private:
    std::deque<LinuxSignal> all_;
    std::uint64_t added_ = 0;
};

// What each thread has of its own.
struct ThreadSignals {
    std::uint64_t blocked = 0;                // bit n: signal n + 1
    std::optional<std::uint64_t> waits_with;  // the mask before a call that changes it meanwhile
    PendingSignals pending{};
    std::uint32_t stack = 0, stack_size = 0;  // of sigaltstack

    void restore_mask() {
        if (waits_with) blocked = *waits_with;
        waits_with.reset();
    }

    // Writes the frame to the program's stack and jumps to the handler; false: no room there.
    bool enter(ArmCore& core, AddressSpace& memory, LinuxSignals::Action& action,
               const LinuxSignal& signal);
    // Returns from it; `rt`: the kind of frame.  False: the frame cannot be read.
    bool leave(ArmCore& core, const AddressSpace& memory, bool rt);
};

}  // namespace sim
