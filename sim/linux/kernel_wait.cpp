// kernel_wait.cpp - LinuxKernel's calls that wait for open files: select, poll and their kind
//
// Only reading from the console can have to wait; everything else is always ready.
#include <algorithm>
#include <cerrno>
#include <vector>

#include "sim/linux/arm_abi.h"
#include "sim/linux/kernel.h"

namespace sim {

namespace {

struct PollEntry {
    std::int32_t fd;
    std::int16_t events, found;
};
constexpr std::int16_t POLL_IN = 0x41, POLL_OUT = 0x104,
                       POLL_INVALID = 0x20;  // with RDNORM, WRNORM

}  // namespace

// Nanoseconds, LONGEST_NS where `address` is 0, or an error.
std::int64_t LinuxKernel::span_at(std::uint32_t address, Span kind) const {
    std::int64_t time[2];
    std::int32_t narrow[2];
    if (address == 0) return LONGEST_NS;
    if (kind == Span::TIMESPEC64 ? !memory_.read(address, time, sizeof time)
                                 : !memory_.read(address, narrow, sizeof narrow))
        return -EFAULT;
    if (kind != Span::TIMESPEC64) std::copy_n(narrow, 2, time);
    if (kind == Span::TIMEVAL) time[1] *= 1000;
    if (time[0] < 0 || time[1] < 0 || time[1] >= static_cast<std::int64_t>(NS)) return -EINVAL;
    const std::int64_t seconds = std::min<std::int64_t>(time[0], LONGEST_NS / NS - 1);
    return seconds * static_cast<std::int64_t>(NS) + time[1];
}

// Stores the remaining time as the kernel does.
void LinuxKernel::give_span(std::uint32_t address, Span kind, std::uint64_t ns) {
    if (address == 0) return;
    if (kind == Span::TIMEVAL) {
        const std::uint32_t time[2] = {static_cast<std::uint32_t>(ns / NS),
                                       static_cast<std::uint32_t>(ns % NS / 1000)};
        memory_.write(address, time, sizeof time);
    } else {
        give_time(address, ns, kind == Span::TIMESPEC64);
    }
}

// Waits until `look` returns other than 0, or for `span_ns`; returns its result and the time left.
std::pair<std::int64_t, std::uint64_t> LinuxKernel::wait_for(
    std::int64_t span_ns, bool at_console, const std::function<std::int64_t()>& look) {
    const std::uint64_t end = now_ns() + static_cast<std::uint64_t>(span_ns);
    for (;;) {
        const std::int64_t found = look();
        const std::uint64_t now = now_ns(), left = now < end ? end - now : 0;
        if (found != 0 || left == 0) return {found, left};
        const auto time = sc_core::sc_time::from_value(left * 1000);
        if (at_console)
            terminal_.wait(time);
        else
            cpu_.pause(time);
    }
}

bool LinuxKernel::is_readable(int fd) const {
    return !files_.is_console(fd) || terminal_.readable();
}

// ---- select: descriptors to read, to write and with exceptions, a bit each ----------------------

std::int64_t LinuxKernel::select(const Arguments& a, Span kind) {
    constexpr std::uint32_t MOST = 1024;
    if (static_cast<std::int32_t>(a[0]) < 0) return -EINVAL;
    const std::uint32_t count = std::min(a[0], MOST);
    const std::int64_t span = span_at(a[4], kind);
    if (span < 0) return span;
    std::vector<std::uint32_t> asked[3], ready[3];
    bool at_console = false;
    for (unsigned set = 0; set < 3; ++set) {
        asked[set].resize((count + 31) / 32);
        const std::size_t bytes = 4 * asked[set].size();
        if (a[1 + set] && bytes && !memory_.read(a[1 + set], asked[set].data(), bytes))
            return -EFAULT;
        if (count % 32) asked[set].back() &= (1u << count % 32) - 1;
        for (std::uint32_t fd = 0; fd < count; ++fd) {
            if (!(asked[set][fd / 32] >> fd % 32 & 1)) continue;
            if (files_.flags(static_cast<int>(fd)) < 0) return -EBADF;
            at_console |= set == 0 && files_.is_console(static_cast<int>(fd));
        }
    }
    const auto [found, left] = wait_for(span, at_console, [&] {
        std::int64_t bits = 0;
        ready[0] = asked[0], ready[1] = asked[1], ready[2].assign(asked[2].size(), 0);
        for (std::uint32_t fd = 0; fd < count; ++fd) {
            if (!is_readable(static_cast<int>(fd))) ready[0][fd / 32] &= ~(1u << fd % 32);
            bits += (ready[0][fd / 32] >> fd % 32 & 1) + (ready[1][fd / 32] >> fd % 32 & 1);
        }
        return bits;
    });
    for (unsigned set = 0; set < 3; ++set)
        if (a[1 + set] && count)
            memory_.write(a[1 + set], ready[set].data(), 4 * ready[set].size());
    give_span(a[4], kind, left);
    return found;
}

LinuxKernel::Result LinuxKernel::sys_select(const Arguments& a) { return select(a, Span::TIMEVAL); }
LinuxKernel::Result LinuxKernel::sys_pselect6(const Arguments& a) {
    return select(a, Span::TIMESPEC);
}
LinuxKernel::Result LinuxKernel::sys_pselect6_time64(const Arguments& a) {
    return select(a, Span::TIMESPEC64);
}

// ---- poll: a list of descriptors ----------------------------------------------------------------

std::int64_t LinuxKernel::poll(std::uint32_t list, std::uint32_t count, std::int64_t span_ns) {
    constexpr std::uint32_t MOST = 1024;
    if (span_ns < 0) return span_ns;
    if (count > MOST) return -EINVAL;
    std::vector<PollEntry> entries(count);
    const std::size_t bytes = count * sizeof(PollEntry);
    if (count && !memory_.read(list, entries.data(), bytes)) return -EFAULT;
    const bool at_console = std::any_of(entries.begin(), entries.end(), [&](const PollEntry& e) {
        return (e.events & POLL_IN) && files_.is_console(e.fd);
    });
    const auto found = wait_for(span_ns, at_console, [&] {
        for (PollEntry& e : entries) {
            e.found = 0;
            if (e.fd < 0) continue;
            const int to_read = is_readable(e.fd) ? POLL_IN : 0;
            e.found = static_cast<std::int16_t>(
                files_.flags(e.fd) < 0 ? POLL_INVALID : e.events & (to_read | POLL_OUT));
        }
        return static_cast<std::int64_t>(std::count_if(
            entries.begin(), entries.end(), [](const PollEntry& e) { return e.found != 0; }));
    });
    if (count && !memory_.write(list, entries.data(), bytes)) return -EFAULT;
    return found.first;
}

LinuxKernel::Result LinuxKernel::sys_poll(const Arguments& a) {
    const auto ms = static_cast<std::int32_t>(a[2]);
    return poll(a[0], a[1], ms < 0 ? static_cast<std::int64_t>(LONGEST_NS) : ms * 1'000'000LL);
}
LinuxKernel::Result LinuxKernel::sys_ppoll(const Arguments& a) {
    return poll(a[0], a[1], span_at(a[2], Span::TIMESPEC));
}
LinuxKernel::Result LinuxKernel::sys_ppoll_time64(const Arguments& a) {
    return poll(a[0], a[1], span_at(a[2], Span::TIMESPEC64));
}

}  // namespace sim
