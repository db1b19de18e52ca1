// thread.h - a thread of a Linux program: its registers, its signals, what it waits for.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "sim/cpu/arm_core.h"
#include "sim/linux/signals.h"

namespace sim {

struct LinuxProcess;

// What a thread waits for within a system call.
struct LinuxWait {
    static constexpr std::uint64_t NEVER = ~std::uint64_t{0};

    // The call's result, if it need not wait any longer.  Called when files have changed, and at
    // `at_ns`, which it may move.
    std::function<std::optional<std::int64_t>(LinuxWait&)> look{};
    std::function<void()> interrupted{};  // by a signal, which need not end it
    std::string what{};                   // "standard input"
    std::uint64_t at_ns = NEVER;          // simulated
    bool restarts = false;                // after a handler of a signal with SA_RESTART
    bool inside = false;                  // only another thread can end it
    bool uninterrupted = false;           // by signals, but for those that end the process
    bool by_signal = false;               // of a module's: a signal to its program ends it
    bool idle = false;                    // of a module's: it has nothing to do
    std::int64_t done = 0;                // the result if a signal comes, unless 0
};

// How a thread shares the processor.
struct LinuxShare {
    int policy = 0, priority = 0, nice = 0;  // SCHED_OTHER; of real time, 1 - 99
    std::uint64_t used_ns = 0;               // weighted, as Linux's vruntime
    std::uint64_t turn = 0;                  // when it became ready, among others
};

// Its registers are those that it has while another thread runs.
struct LinuxThread : ArmRegisters {
    LinuxThread(int its_number, LinuxProcess& its_process)
        : number{its_number}, process{its_process} {}

    int number;
    LinuxProcess& process;
    ThreadSignals signals{};
    std::optional<LinuxWait> wait{};
    bool ready = false;     // in the scheduler's queue
    bool restarts = false;  // the call that it was in begins again, unless a handler forbids it
    bool in_vfork = false;  // its child has its memory
    LinuxShare share{};
    std::uint32_t clears = 0, robust_list = 0;  // at its end: a word to clear, locks to give back
    std::uint32_t sequences = 0;                // struct rseq
    std::uint32_t affinity = 3;                 // processors that it may use
    std::uint64_t used_ns = 0;                  // of the processor
    std::uint32_t request = 0;                  // of a module's: where it awaits requests
    std::string name{};
    std::uint32_t tls = 0, own_tls = 0;  // TPIDRURO, TPIDRURW, while another thread runs

    void save(const ArmCore& core);
    void load(ArmCore& core) const;  // without tls
};

}  // namespace sim
