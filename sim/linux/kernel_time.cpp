// kernel_time.cpp - LinuxKernel's calls for time: clocks and sleep
#include <algorithm>
#include <cerrno>
#include <utility>

#include "sim/linux/kernel.h"

namespace sim {

namespace {

constexpr std::uint32_t CLOCKS = 12, ABSOLUTE = 1;

}  // namespace

// struct timespec, or with `wide` struct __kernel_timespec.
std::int64_t LinuxKernel::give_time(std::uint32_t to, std::uint64_t ns, bool wide) {
    const std::uint64_t seconds = ns / NS, rest = ns % NS;
    if (wide) {
        const std::uint64_t time[2] = {seconds, rest};
        return memory().write(to, time, sizeof time) ? 0 : -EFAULT;
    }
    const std::uint32_t time[2] = {static_cast<std::uint32_t>(seconds),
                                   static_cast<std::uint32_t>(rest)};
    return memory().write(to, time, sizeof time) ? 0 : -EFAULT;
}

std::uint64_t LinuxKernel::used_ns(const LinuxProcess& process) const {
    const bool runs = running_ && &running_->process == &process;
    return process.used_ns + (runs ? now_ns() - since_ns_ : 0);
}

std::uint64_t LinuxKernel::used_ns(const LinuxThread& thread) const {
    return thread.used_ns + (running_ == &thread ? now_ns() - since_ns_ : 0);
}

// No value: there is no such clock.  Below 0 are those of a process or a thread by its number.
std::optional<std::uint64_t> LinuxKernel::clock_ns(std::uint32_t clock) const {
    constexpr std::uint32_t PROCESS = 2, THREAD = 3, OF_A_THREAD = 4;
    if (clock == PROCESS) return used_ns(*process_);
    if (clock == THREAD) return used_ns(*running_);
    if (clock < CLOCKS) return now_ns();
    if (static_cast<std::int32_t>(clock) >= 0) return std::nullopt;
    const auto number = static_cast<std::uint32_t>(~(static_cast<std::int32_t>(clock) >> 3));
    const LinuxThread* const thread = thread_of(number);
    if (!thread) return std::nullopt;
    return clock & OF_A_THREAD ? used_ns(*thread) : used_ns(thread->process);
}

LinuxKernel::Result LinuxKernel::sys_clock_gettime(const Arguments& a) {
    const auto ns = clock_ns(a[0]);
    return ns ? give_time(a[1], *ns, false) : -EINVAL;
}

LinuxKernel::Result LinuxKernel::sys_clock_gettime64(const Arguments& a) {
    const auto ns = clock_ns(a[0]);
    return ns ? give_time(a[1], *ns, true) : -EINVAL;
}

LinuxKernel::Result LinuxKernel::sys_clock_getres(const Arguments& a) {
    if (!clock_ns(a[0])) return -EINVAL;
    return a[1] ? give_time(a[1], 1, false) : 0;
}

LinuxKernel::Result LinuxKernel::sys_clock_getres_time64(const Arguments& a) {
    if (!clock_ns(a[0])) return -EINVAL;
    return a[1] ? give_time(a[1], 1, true) : 0;
}

LinuxKernel::Result LinuxKernel::sys_gettimeofday(const Arguments& a) {
    const std::uint64_t us = now_ns() / 1000;
    const std::uint32_t time[2] = {static_cast<std::uint32_t>(us / 1'000'000),
                                   static_cast<std::uint32_t>(us % 1'000'000)};
    const std::uint32_t zone[2] = {0, 0};
    const bool given = (a[0] == 0 || memory().write(a[0], time, sizeof time)) &&
                       (a[1] == 0 || memory().write(a[1], zone, sizeof zone));
    return given ? 0 : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_times(const Arguments& a) {
    const auto ticks = static_cast<std::uint32_t>(now_ns() / TICK_NS);
    const std::uint32_t times[4] = {static_cast<std::uint32_t>(used_ns(*process_) / TICK_NS), 0, 0,
                                    0};
    if (a[0] != 0 && !memory().write(a[0], times, sizeof times)) return -EFAULT;
    return ticks & 0x7FFFFFFF;
}

// `left`: where the remaining time is stored when a signal ends it.
LinuxKernel::Result LinuxKernel::sleep(std::uint32_t flags, std::uint32_t span, bool wide,
                                       std::uint32_t left) {
    std::uint64_t time[2];
    std::uint32_t narrow[2];
    if (wide ? !memory().read(span, time, sizeof time)
             : !memory().read(span, narrow, sizeof narrow))
        return -EFAULT;
    if (!wide) {
        const std::int64_t seconds = static_cast<std::int32_t>(narrow[0]);
        time[0] = static_cast<std::uint64_t>(seconds);
        time[1] = narrow[1];
    }
    time[1] &= 0xFFFFFFFF;  // a long: what lies above is not set by all libraries
    if (static_cast<std::int64_t>(time[0]) < 0 || time[1] >= NS) return -EINVAL;
    std::uint64_t ns = LONGEST_NS;
    if (time[0] < LONGEST_NS / NS) ns = time[0] * NS + time[1];
    LinuxWait wait;
    wait.what = "the time to wake up";
    wait.at_ns = flags & ABSOLUTE ? ns : ns == 0 ? now_ns() : later_ns(ns);
    wait.look = [this](LinuxWait& w) { return now_ns() >= w.at_ns ? Result{0} : std::nullopt; };
    if (left != 0 && !(flags & ABSOLUTE))
        wait.interrupted = [this, left, wide, end = wait.at_ns, &thread = *running_] {
            LinuxProcess* const present = std::exchange(process_, &thread.process);
            give_time(left, end > now_ns() ? end - now_ns() : 0, wide);
            process_ = present;
        };
    return this->wait(std::move(wait));
}

LinuxKernel::Result LinuxKernel::sys_nanosleep(const Arguments& a) {
    return sleep(0, a[0], false, a[1]);
}

LinuxKernel::Result LinuxKernel::sys_clock_nanosleep(const Arguments& a) {
    return a[0] < CLOCKS ? sleep(a[1], a[2], false, a[3]) : -EINVAL;
}

LinuxKernel::Result LinuxKernel::sys_clock_nanosleep_time64(const Arguments& a) {
    return a[0] < CLOCKS ? sleep(a[1], a[2], true, a[3]) : -EINVAL;
}

}  // namespace sim
