// posix_timers.h - a Linux process's timers by timer_create(): what each is set to, what it sends.
//
// A timer has one signal of its own.  While that is pending, an interval timer rests; when it is
// taken, the times that have passed since are its overrun.
//
// Source: Linux 6.1, kernel/time/posix-timers.c.
#pragma once

#include <algorithm>
#include <cstdint>

#include "sim/linux/timers.h"

namespace sim {

struct PosixTimer {
    static constexpr std::size_t MOST = 1024;  // of a process

    // As sigevent's sigev_notify.
    enum Notify : std::uint32_t { SIGNAL = 0, NONE = 1, THREAD = 2, THREAD_ID = 4 };
    enum class Clock { REAL, PROCESS, THREAD };  // real; processor time of one of these

    Clock clock = Clock::REAL;
    int of = 0;  // the process or thread whose processor time it is
    std::uint32_t notify = SIGNAL;
    unsigned signal = 0;
    std::uint32_t value = 0;
    int thread = 0;  // that gets the signal, with THREAD_ID

    LinuxTimer timer{};
    bool runs = false;           // and sends when it expires
    bool rests = false;          // until its signal is taken
    std::uint32_t sequence = 0;  // changes with each signal and each setting
    std::int64_t overrun = -1;   // so far, of the signal that comes next

    void set(const LinuxTimer& to) {
        timer = to;
        runs = to.is_set() && notify != NONE;
        rests = false;
        ++sequence;
        last_overrun_ = 0;
    }
    // As timer_gettime() has it.
    LinuxTimer left(std::uint64_t now_ns) {
        if (timer.interval_ns != 0 && (rests || notify == NONE))
            overrun += static_cast<std::int64_t>(timer.expire(now_ns));
        const bool is_over = timer.interval_ns == 0 && !runs && notify != NONE;
        return is_over || (notify == NONE && timer.at_ns <= now_ns) ? LinuxTimer{} : timer;
    }
    // It goes on, with times left out until now.
    void go_on(std::uint64_t now_ns) {
        overrun += static_cast<std::int64_t>(timer.expire(now_ns));
        runs = true;
        rests = false;
        ++sequence;
    }
    // Its signal is taken: returns how often it has expired besides.
    std::int32_t take_overrun() {
        last_overrun_ = overrun;
        overrun = -1;
        return last_overrun();
    }
    std::int32_t last_overrun() const {
        return static_cast<std::int32_t>(std::min<std::int64_t>(last_overrun_, INT32_MAX));
    }

private:
    std::int64_t last_overrun_ = 0;
};

}  // namespace sim
