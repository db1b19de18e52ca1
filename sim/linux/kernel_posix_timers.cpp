// kernel_posix_timers.cpp - LinuxKernel's timers of timer_create: when they expire, their calls
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <vector>

#include "sim/linux/arm_abi.h"
#include "sim/linux/kernel.h"

namespace sim {

namespace {

constexpr std::uint32_t AT_THIS_TIME = 1;                       // TIMER_ABSTIME
constexpr std::uint64_t IGNORED_REST_NS = 1'000'000'000 / 100;  // a tick: HZ is 100 on the board

PosixTimer* posix_timer(LinuxProcess& process, std::uint32_t number) {
    const auto found = process.timers.find(static_cast<int>(number));
    return found == process.timers.end() ? nullptr : &found->second;
}

}  // namespace

// ---- When they expire ---------------------------------------------------------------------------

// Of its clock; no value: whose processor time it is has ended.
std::optional<std::uint64_t> LinuxKernel::now_of(const PosixTimer& timer) const {
    if (timer.clock == PosixTimer::Clock::REAL) return now_ns();
    if (timer.clock == PosixTimer::Clock::THREAD) {
        const LinuxThread* const thread = thread_of(static_cast<std::uint32_t>(timer.of));
        return thread ? std::optional{used_ns(*thread)} : std::nullopt;
    }
    const LinuxProcess* const process = process_of(timer.of);
    return process && !process->status ? std::optional{used_ns(*process)} : std::nullopt;
}

// When it will be so late on a clock of processor time that passes now.
std::uint64_t LinuxKernel::at_used_ns(std::uint64_t at_ns, std::uint64_t used) const {
    return at_ns == LinuxWait::NEVER ? at_ns : now_ns() + (at_ns > used ? at_ns - used : 0);
}

std::uint64_t LinuxKernel::next_posix_timer_ns() const {
    std::uint64_t next = LinuxWait::NEVER;
    for (const auto& process : processes_) {
        if (process->status) continue;
        for (const auto& [number, timer] : process->timers) {
            const bool of_thread = timer.clock == PosixTimer::Clock::THREAD;
            if (!timer.runs) continue;
            if (timer.clock == PosixTimer::Clock::REAL)
                next = std::min(next, timer.timer.at_ns);
            else if (running_ &&
                     timer.of == (of_thread ? running_->number : running_->process.number))
                next = std::min(next, at_used_ns(timer.timer.at_ns, *now_of(timer)));
        }
    }
    return next;
}

// Those that are due, in the order of their times.
void LinuxKernel::expire_posix_timers() {
    struct Due {
        std::uint64_t since_ns;
        LinuxProcess* process;
        int number;
    };
    std::vector<Due> all;
    for (const auto& process : processes_) {
        if (process->status) continue;
        for (auto& [number, timer] : process->timers) {
            const auto now = timer.runs ? now_of(timer) : std::nullopt;
            if (now && timer.timer.at_ns <= *now)
                all.push_back({*now - timer.timer.at_ns, process.get(), number});
        }
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const Due& a, const Due& b) { return a.since_ns > b.since_ns; });
    const auto is_there = [this](const LinuxProcess* one) {  // one before it may have ended it
        return std::any_of(processes_.begin(), processes_.end(), [&](const auto& process) {
            return process.get() == one && !process->status;
        });
    };
    for (const Due& due : all)
        if (is_there(due.process))
            expire(*due.process, due.number, due.process->timers.at(due.number));
}

// Source: kernel/time/posix-timers.c, posix_timer_fn(); kernel/signal.c, send_sigqueue().
void LinuxKernel::expire(LinuxProcess& process, int number, PosixTimer& timer) {
    const bool again = timer.timer.interval_ns != 0;
    LinuxSignal signal{timer.signal, arm_signal_code::TIMER, {}, "a timer expired,"};
    signal.fields = {static_cast<std::uint32_t>(number), 0, timer.value};
    signal.timer = {number, again ? ++timer.sequence : 0};
    timer.runs = false;
    timer.rests = again;
    const bool to_one = timer.notify & PosixTimer::THREAD_ID;
    LinuxThread* const thread =
        to_one ? thread_of(static_cast<std::uint32_t>(timer.thread)) : nullptr;
    if (to_one && (!thread || &thread->process != &process)) return;  // it has ended
    const auto is_pending = [&](PendingSignals& pending) {
        LinuxSignal* const before = pending.of_timer(number);
        if (before) ++before->fields[1], before->timer = signal.timer;
        return before != nullptr;
    };
    if (is_pending(process.pending)) return;
    for (const auto& one : process.threads)
        if (is_pending(one->signals.pending)) return;
    const auto blocks = [&](const auto& one) {
        return (one->signals.blocked & LinuxSignals::bit(timer.signal)) != 0;
    };
    const bool blocked = to_one
                             ? blocks(thread)
                             : std::all_of(process.threads.begin(), process.threads.end(), blocks);
    if (!blocked && process.signals.ignores(timer.signal)) {
        // It comes again with the next tick at the earliest, or it would do nothing else.
        const bool is_short = timer.timer.interval_ns < IGNORED_REST_NS;
        if (again) timer.go_on(*now_of(timer) + (is_short ? IGNORED_REST_NS : 0));
    } else if (to_one) {
        send(*thread, signal);
    } else {
        send(process, signal);
    }
}

// A signal is taken: the timer that sent it goes on, unless it has been set again.
void LinuxKernel::go_on_with_timer(LinuxProcess& process, LinuxSignal& signal) {
    if (signal.timer.sequence == 0) return;
    PosixTimer* const timer = posix_timer(process, static_cast<std::uint32_t>(signal.timer.number));
    if (!timer || !timer->rests || timer->sequence != signal.timer.sequence) return;
    const auto now = now_of(*timer);
    if (!now) return;
    timer->go_on(*now);
    signal.fields[1] += static_cast<std::uint32_t>(timer->take_overrun());
}

// As a process becomes another program.
void LinuxKernel::delete_posix_timers(LinuxProcess& process) {
    process.timers.clear();
    process.pending.remove_timers();
    for (const auto& thread : process.threads) thread->signals.pending.remove_timers();
}

// ---- The calls ----------------------------------------------------------------------------------

// Source: kernel/time/posix-timers.c, good_sigevent(), do_timer_create().
LinuxKernel::Result LinuxKernel::sys_timer_create(const Arguments& a) {
    struct {
        std::uint32_t value, signal, notify, thread, rest[12];
    } event{};
    static_assert(sizeof event == 64);
    const int number = process_->next_timer;
    if (a[1] != 0 && !memory().read(a[1], &event, sizeof event)) return -EFAULT;
    if (a[1] == 0) event = {static_cast<std::uint32_t>(number), SIGALRM, PosixTimer::SIGNAL, 0, {}};
    PosixTimer timer;
    if (const std::int64_t error = clock_for_timer(a[0], timer)) return error;
    if (process_->timers.size() >= PosixTimer::MOST) return -EAGAIN;
    const bool to_one = event.notify == PosixTimer::THREAD_ID;
    if (!to_one && event.notify > PosixTimer::THREAD) return -EINVAL;
    if (event.notify != PosixTimer::NONE &&
        (event.signal < 1 || event.signal > LinuxSignals::COUNT))
        return -EINVAL;
    const LinuxThread* const thread = event.thread != 0 ? thread_of(event.thread) : nullptr;
    if (to_one && (!thread || &thread->process != process_)) return -EINVAL;
    if (!memory().write(a[2], &number, sizeof number)) return -EFAULT;
    timer.notify = event.notify;
    timer.signal = event.signal;
    timer.value = event.value;
    timer.thread = to_one ? thread->number : 0;
    process_->timers.emplace(number, timer);
    ++process_->next_timer;
    return 0;
}

// Source: kernel/time/posix-timers.c, posix_clocks; posix-cpu-timers.c, pid_for_clock().
std::int64_t LinuxKernel::clock_for_timer(std::uint32_t clock, PosixTimer& timer) const {
    constexpr std::uint32_t REALTIME = 0, MONOTONIC = 1, OF_PROCESS = 2, OF_THREAD = 3,
                            MONOTONIC_RAW = 4, COARSE = 6, BOOTTIME = 7, BOOTTIME_ALARM = 9,
                            TAI = 11, THREADS = 4, WHICH = 3;
    if (clock == REALTIME || clock == MONOTONIC || clock == BOOTTIME || clock == TAI) return 0;
    if (clock == OF_PROCESS || clock == OF_THREAD) {
        timer.clock = clock == OF_THREAD ? PosixTimer::Clock::THREAD : PosixTimer::Clock::PROCESS;
        timer.of = clock == OF_THREAD ? running_->number : process_->number;
        return 0;
    }
    const bool only_tells = clock >= MONOTONIC_RAW && clock <= COARSE;
    const bool only_with_rtc = clock > BOOTTIME && clock <= BOOTTIME_ALARM;
    if (only_tells || only_with_rtc) return -EOPNOTSUPP;
    if (static_cast<std::int32_t>(clock) >= 0) return -EINVAL;
    if ((clock & WHICH) == WHICH) return clock & THREADS ? -EINVAL : -EOPNOTSUPP;
    const auto number = static_cast<std::uint32_t>(~(static_cast<std::int32_t>(clock) >> 3));
    const LinuxThread* const thread = thread_of(number);
    if (!thread) return -EINVAL;
    const bool first = number == 0 || thread->number == thread->process.number;
    if (clock & THREADS ? &thread->process != process_ : !first) return -EINVAL;
    timer.clock = clock & THREADS ? PosixTimer::Clock::THREAD : PosixTimer::Clock::PROCESS;
    timer.of = clock & THREADS ? thread->number : thread->process.number;
    return 0;
}

LinuxKernel::Result LinuxKernel::timer_settime(const Arguments& a, Span kind) {
    if (a[2] == 0) return -EINVAL;
    const std::int64_t interval = span_at(a[2], kind);
    if (interval < 0) return interval;
    const std::int64_t value = span_at(a[2] + (kind == Span::TIMESPEC64 ? 16 : 8), kind);
    if (value < 0) return value;
    PosixTimer* const timer = posix_timer(*process_, a[0]);
    if (!timer) return -EINVAL;
    const auto now = now_of(*timer);
    if (!now) return -ESRCH;
    const LinuxTimer old = a[3] != 0 ? timer->left(*now) : LinuxTimer{};
    const auto ns = static_cast<std::uint64_t>(value);
    LinuxTimer to;
    if (value != 0)
        to = {a[1] & AT_THIS_TIME                       ? ns
              : timer->clock == PosixTimer::Clock::REAL ? later_ns(ns)
                                                        : *now + ns,
              static_cast<std::uint64_t>(interval)};
    timer->set(to);
    return a[3] == 0 ? 0 : give_timer(a[3], old, kind, *now);
}

LinuxKernel::Result LinuxKernel::timer_gettime(const Arguments& a, Span kind) {
    PosixTimer* const timer = posix_timer(*process_, a[0]);
    if (!timer) return -EINVAL;
    const auto now = now_of(*timer);
    return give_timer(a[1], now ? timer->left(*now) : LinuxTimer{}, kind, now.value_or(0));
}

LinuxKernel::Result LinuxKernel::sys_timer_settime(const Arguments& a) {
    return timer_settime(a, Span::TIMESPEC);
}
LinuxKernel::Result LinuxKernel::sys_timer_settime64(const Arguments& a) {
    return timer_settime(a, Span::TIMESPEC64);
}
LinuxKernel::Result LinuxKernel::sys_timer_gettime(const Arguments& a) {
    return timer_gettime(a, Span::TIMESPEC);
}
LinuxKernel::Result LinuxKernel::sys_timer_gettime64(const Arguments& a) {
    return timer_gettime(a, Span::TIMESPEC64);
}

LinuxKernel::Result LinuxKernel::sys_timer_getoverrun(const Arguments& a) {
    const PosixTimer* const timer = posix_timer(*process_, a[0]);
    return timer ? timer->last_overrun() : -EINVAL;
}

// A signal that it has sent stays pending.
LinuxKernel::Result LinuxKernel::sys_timer_delete(const Arguments& a) {
    return process_->timers.erase(static_cast<int>(a[0])) ? 0 : -EINVAL;
}

}  // namespace sim
