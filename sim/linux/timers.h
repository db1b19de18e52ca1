// timers.h - timers of a Linux program: setitimer's, and open files of timerfd.
#pragma once

#include <cstdint>
#include <cstring>
#include <functional>
#include <string>

#include "sim/linux/device.h"
#include "sim/linux/thread.h"

namespace sim {

struct LinuxTimer {
    std::uint64_t at_ns = LinuxWait::NEVER, interval_ns = 0;  // 0: it expires once

    bool is_set() const { return at_ns != LinuxWait::NEVER; }
    std::uint64_t left_ns(std::uint64_t now_ns) const {
        return !is_set() ? 0 : at_ns > now_ns ? at_ns - now_ns : 1;
    }
    // How often it has expired since it was set, or since this was asked.
    std::uint64_t expire(std::uint64_t now_ns) {
        if (at_ns > now_ns) return 0;
        const std::uint64_t times = interval_ns ? (now_ns - at_ns) / interval_ns + 1 : 1;
        at_ns = interval_ns ? at_ns + times * interval_ns : LinuxWait::NEVER;
        return times;
    }
};

// Source: timerfd_create(2).
class LinuxTimerFile final : public LinuxDevice {
public:
    explicit LinuxTimerFile(std::function<std::uint64_t()> now_ns) : now_ns_{std::move(now_ns)} {}

    LinuxTimer timer;
    std::uint64_t expired = 0;  // and not read

    FileStatus status() const override { return {0600, 0, 1, 0}; }
    std::string name() const override { return "a timer"; }
    unsigned can_do() const override { return expired > 0 || timer.at_ns <= now_ns_() ? READ : 0; }
    std::int64_t read(void* data, std::size_t bytes) override {
        if (bytes < sizeof expired) return -EINVAL;
        expired += timer.expire(now_ns_());
        if (expired == 0) return -EAGAIN;
        std::memcpy(data, &expired, sizeof expired);
        expired = 0;
        return sizeof expired;
    }

private:
    std::function<std::uint64_t()> now_ns_;
};

}  // namespace sim
