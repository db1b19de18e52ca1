// signal_file.h - an open file of signalfd: a thread reads its blocked signals from it.
//
// Which thread's they are is decided anew by each read and each poll: the caller's.
//
// Source: Linux 6.1, fs/signalfd.c; struct signalfd_siginfo.
#pragma once

#include <csignal>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "sim/linux/device.h"
#include "sim/linux/signals.h"

namespace sim {

class LinuxSignalFile final : public LinuxDevice {
public:
    // Of the thread that calls, and its process.
    struct Caller {
        std::function<std::uint64_t()> pending;
        std::function<std::uint64_t()> arrivals;  // how many signals it has got so far
        std::function<std::optional<LinuxSignal>(std::uint64_t set)> take;
    };

    LinuxSignalFile(Caller caller, std::uint64_t signals)
        : mask{signals}, caller_{std::move(caller)} {}

    std::uint64_t mask;  // the signals that it is for

    FileStatus status() const override { return {0600, 0, 1, 0}; }
    std::string name() const override { return "a signal"; }
    unsigned can_do() const override { return caller_.pending() & mask ? READ : 0; }
    std::uint64_t arrivals() const override { return caller_.arrivals(); }
    std::int64_t read(void* data, std::size_t bytes) override {
        if (bytes < sizeof(Info)) return -EINVAL;
        auto* to = static_cast<std::uint8_t*>(data);
        std::size_t count = 0;
        for (; count < bytes / sizeof(Info); ++count) {
            const auto signal = caller_.take(mask);
            if (!signal) break;
            const Info info = info_of(*signal);
            std::memcpy(to + count * sizeof info, &info, sizeof info);
        }
        return count > 0 ? static_cast<std::int64_t>(count * sizeof(Info)) : -EAGAIN;
    }

private:
    struct Info {
        std::uint32_t number;
        std::int32_t error, code;
        std::uint32_t process, user;
        std::int32_t file;
        std::uint32_t timer, band, overrun, trap;
        std::int32_t status, value;
        std::uint64_t pointer, user_ticks, system_ticks, address;
        std::uint8_t rest[48];
    };
    static_assert(sizeof(Info) == 128);

    // Source: kernel/signal.c, siginfo_layout().
    static Info info_of(const LinuxSignal& signal) {
        Info info{};
        const auto& fields = signal.fields;
        const bool of_child = signal.number == SIGCHLD && signal.code > arm_signal_code::USER &&
                              signal.code < arm_signal_code::KERNEL;
        info.number = signal.number;
        info.code = signal.code;
        (signal.code == arm_signal_code::TIMER ? info.timer : info.process) = fields[0];
        (signal.code == arm_signal_code::TIMER ? info.overrun : info.user) = fields[1];
        if (of_child) {
            info.status = static_cast<std::int32_t>(fields[2]);
            info.user_ticks = fields[3];
        } else if (signal.code < arm_signal_code::USER) {
            info.value = static_cast<std::int32_t>(fields[2]);
            info.pointer = static_cast<std::uint64_t>(std::int64_t{info.value});  // a long
        }
        return info;
    }

    Caller caller_;
};

}  // namespace sim
