// kernel_timers.cpp - LinuxKernel's calls for timers: setitimer, which alarm() is, and timerfd
#include <algorithm>
#include <cerrno>
#include <csignal>

#include "sim/linux/arm_abi.h"
#include "sim/linux/kernel.h"

namespace sim {

namespace {

constexpr std::uint32_t TIMER_CLOCKS = 12, ITIMERS = 3, AT_A_TIME = 1;
constexpr unsigned ITIMER_SIGNALS[ITIMERS] = {SIGALRM, SIGVTALRM, SIGPROF};

}  // namespace

// ---- When they expire ---------------------------------------------------------------------------

std::uint64_t LinuxKernel::next_timer_ns() const {
    std::uint64_t next = next_posix_timer_ns();
    for (const auto& process : processes_) next = std::min(next, process->itimers[0].at_ns);
    for (std::size_t i = 1; running_ && i < ITIMERS; ++i)
        next = std::min(next,
                        at_used_ns(running_->process.itimers[i].at_ns, used_ns(running_->process)));
    for (const auto& file : timer_files_)
        if (const auto timer = file.lock()) next = std::min(next, timer->timer.at_ns);
    return next;
}

void LinuxKernel::expire_timers() {
    const std::uint64_t now = now_ns();
    expire_posix_timers();
    for (const auto& process : processes_)
        for (std::size_t i = 0; i < ITIMERS; ++i)
            if (process->itimers[i].expire(i == 0 ? now : used_ns(*process)) > 0)
                send(*process,
                     {ITIMER_SIGNALS[i], arm_signal_code::KERNEL, {}, "a timer expired,"});
    for (auto file = timer_files_.begin(); file != timer_files_.end();) {
        const auto timer = file->lock();
        if (timer) {
            const std::uint64_t times = timer->timer.expire(now);
            timer->expired += times;
            changed_ |= times > 0;
        }
        file = timer ? std::next(file) : timer_files_.erase(file);
    }
}

// ---- struct itimerval, itimerspec: the interval, then the time until it expires -----------------

std::int64_t LinuxKernel::give_timer(std::uint32_t to, const LinuxTimer& timer, Span kind,
                                     std::uint64_t now) {
    const std::uint32_t bytes = kind == Span::TIMESPEC64 ? 16 : 8;
    if (!memory().bytes(to, 2 * bytes, arm_access::WRITE)) return -EFAULT;
    give_span(to, kind, timer.interval_ns);
    give_span(to + bytes, kind, timer.left_ns(now));
    return 0;
}

std::int64_t LinuxKernel::set_timer(LinuxTimer& timer, std::uint32_t from, std::uint32_t old,
                                    Span kind, bool absolute, std::optional<std::uint64_t> used) {
    const std::int64_t interval = from ? span_at(from, kind) : -EFAULT;
    if (interval < 0) return interval;
    const std::int64_t value = span_at(from + (kind == Span::TIMESPEC64 ? 16 : 8), kind);
    if (value < 0) return value;
    if (old)
        if (const std::int64_t error = give_timer(old, timer, kind, used.value_or(now_ns())))
            return error;
    const auto ns = static_cast<std::uint64_t>(value);
    timer = {value == 0 ? LinuxWait::NEVER
             : absolute ? ns
             : used     ? *used + ns
                        : later_ns(ns),
             static_cast<std::uint64_t>(interval)};
    return 0;
}

// A process's time in the kernel is not told from its own, so ITIMER_VIRTUAL counts as ITIMER_PROF.
LinuxKernel::Result LinuxKernel::sys_setitimer(const Arguments& a) {
    constexpr std::uint32_t NO_TIME[4] = {};
    if (a[0] >= ITIMERS) return -EINVAL;
    LinuxTimer& timer = process_->itimers[a[0]];
    if (a[1] == 0) {
        timer = {};
        return a[2] == 0 || memory().write(a[2], NO_TIME, sizeof NO_TIME) ? 0 : -EFAULT;
    }
    std::optional<std::uint64_t> used;
    if (a[0] != 0) used = used_ns(*process_);
    return set_timer(timer, a[1], a[2], Span::TIMEVAL, false, used);
}

LinuxKernel::Result LinuxKernel::sys_getitimer(const Arguments& a) {
    if (a[0] >= ITIMERS) return -EINVAL;
    return give_timer(a[1], process_->itimers[a[0]], Span::TIMEVAL,
                      a[0] == 0 ? now_ns() : used_ns(*process_));
}

// ---- timerfd ------------------------------------------------------------------------------------

LinuxKernel::Result LinuxKernel::sys_timerfd_create(const Arguments& a) {
    if (a[0] >= TIMER_CLOCKS || a[1] & ~(arm_open::NONBLOCK | arm_open::CLOEXEC)) return -EINVAL;
    const auto file = std::make_shared<LinuxTimerFile>([this] { return now_ns(); });
    timer_files_.push_back(file);
    return files().add(file, a[1]);
}

LinuxKernel::Result LinuxKernel::timerfd(const Arguments& a, Span kind, bool sets) {
    const int fd = static_cast<int>(a[0]);
    if (files().flags(fd) < 0) return -EBADF;
    auto* const file = dynamic_cast<LinuxTimerFile*>(files().device(fd));
    if (!file) return -EINVAL;
    if (!sets) return give_timer(a[1], file->timer, kind, now_ns());
    constexpr std::uint32_t CANCEL_ON_SET = 2;  // the real-time clock is never set
    if (a[1] & ~(AT_A_TIME | CANCEL_ON_SET)) return -EINVAL;
    const std::int64_t error = set_timer(file->timer, a[2], a[3], kind, a[1] & AT_A_TIME);
    if (error == 0) file->expired = 0;
    return error;
}

LinuxKernel::Result LinuxKernel::sys_timerfd_settime(const Arguments& a) {
    return timerfd(a, Span::TIMESPEC, true);
}
LinuxKernel::Result LinuxKernel::sys_timerfd_settime64(const Arguments& a) {
    return timerfd(a, Span::TIMESPEC64, true);
}
LinuxKernel::Result LinuxKernel::sys_timerfd_gettime(const Arguments& a) {
    return timerfd(a, Span::TIMESPEC, false);
}
LinuxKernel::Result LinuxKernel::sys_timerfd_gettime64(const Arguments& a) {
    return timerfd(a, Span::TIMESPEC64, false);
}

}  // namespace sim
