// kernel_time.cpp - LinuxKernel's calls for time: clocks and sleep
#include <algorithm>
#include <cerrno>
#include <utility>

#include "sim/linux/kernel.h"

namespace sim {

namespace {

constexpr std::uint32_t CLOCKS = 12, ABSOLUTE = 1;
constexpr std::uint64_t TICK_NS = 10'000'000;  // of times()
constexpr std::uint32_t FUTEX_WAIT = 0, FUTEX_WAKE = 1, FUTEX_WAIT_BITSET = 9,
                        FUTEX_WAKE_BITSET = 10, FUTEX_COMMAND = 0x7F;

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

LinuxKernel::Result LinuxKernel::sys_clock_gettime(const Arguments& a) {
    return a[0] < CLOCKS ? give_time(a[1], now_ns(), false) : -EINVAL;
}

LinuxKernel::Result LinuxKernel::sys_clock_gettime64(const Arguments& a) {
    return a[0] < CLOCKS ? give_time(a[1], now_ns(), true) : -EINVAL;
}

LinuxKernel::Result LinuxKernel::sys_clock_getres(const Arguments& a) {
    if (a[0] >= CLOCKS) return -EINVAL;
    return a[1] ? give_time(a[1], 1, false) : 0;
}

LinuxKernel::Result LinuxKernel::sys_clock_getres_time64(const Arguments& a) {
    if (a[0] >= CLOCKS) return -EINVAL;
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
    const std::uint32_t times[4] = {ticks, 0, 0, 0};
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

// With one thread there is no other thread to wake or to be woken by.
LinuxKernel::Result LinuxKernel::sys_futex(const Arguments& a) {
    switch (a[1] & FUTEX_COMMAND) {
        case FUTEX_WAKE:
        case FUTEX_WAKE_BITSET: return 0;
        case FUTEX_WAIT:
        case FUTEX_WAIT_BITSET: {
            std::uint32_t value;
            if (!memory().read(a[0], &value, sizeof value)) return -EFAULT;
            if (value != a[2]) return -EAGAIN;
            over_ = true;
            cpu_.end("the program waits for a thread, and there is none, " + cpu_.where());
            return 0;
        }
        default: return -ENOSYS;
    }
}

}  // namespace sim
