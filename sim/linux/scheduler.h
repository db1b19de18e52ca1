// scheduler.h - which of the threads that could run does: one processor, shared as by Linux.
//
// Threads of SCHED_OTHER share it by their weights: the one runs that has used least of it, at most
// for its part of LATENCY_NS, but MIN_NS at least.  One that has slept comes before one that has
// computed meanwhile, and takes its place if it is GRANULARITY_NS behind.  Those of SCHED_FIFO and
// SCHED_RR run before all of these, by priority; those of one priority in turns, with SCHED_RR of
// ROUND_NS.  Simulated time decides alone, so every run is the same.
//
// Source: Linux 6.1, kernel/sched/fair.c, of one processor.
//
// Not handled: groups; the board's second processor; deadlines.  A part ends when it is over, not
// with a tick of 10 ms.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/linux/thread.h"

namespace sim {

class LinuxScheduler {
public:
    static constexpr std::uint64_t LATENCY_NS = 6'000'000, MIN_NS = 750'000,
                                   GRANULARITY_NS = 1'000'000, ROUND_NS = 100'000'000;
    static constexpr int OTHER = 0, FIFO = 1, RR = 2, BATCH = 3, IDLE = 5;

    // It could run; `woken`: after it has waited.
    void add(LinuxThread& thread, bool woken);
    void remove(LinuxThread& thread);
    bool empty() const { return queue_.empty(); }

    // The next one, which leaves the queue, and runs from now on; the queue must not be empty.
    LinuxThread& pop(std::uint64_t now_ns);
    // This one of them instead.
    LinuxThread& take(LinuxThread& thread, std::uint64_t now_ns);
    // The one that runs has run until now.
    void account(LinuxThread& running, std::uint64_t now_ns);
    // It has to make way for one in the queue.
    bool preempts(const LinuxThread& running, std::uint64_t now_ns) const;
    // When it will have to, unless another comes; LinuxWait::NEVER.
    std::uint64_t end_of_turn_ns(const LinuxThread& running) const;
    // It makes way by itself, for any that could run.
    void yield(LinuxThread& running);
    // A new one, whose share is its maker's, does not come at once.
    void put_behind(LinuxThread& thread) const;

private:
    bool before(const LinuxThread& a, const LinuxThread& b) const;
    const LinuxThread* first() const;

    std::vector<LinuxThread*> queue_;
    std::uint64_t turn_ = 0, least_used_ns_ = 0;
    std::uint64_t begin_ns_ = 0, accounted_ns_ = 0;  // of the one that runs
};

}  // namespace sim
