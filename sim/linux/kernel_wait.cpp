// kernel_wait.cpp - LinuxKernel's calls that wait for open files: select, poll, epoll
#include <algorithm>
#include <array>
#include <cerrno>
#include <vector>

#include "sim/linux/arm_abi.h"
#include "sim/linux/epoll.h"
#include "sim/linux/kernel.h"

namespace sim {

namespace {

struct PollEntry {
    std::int32_t fd;
    std::int16_t events, found;
};
constexpr std::int16_t POLL_IN = 0x41, POLL_OUT = 0x104;  // with RDNORM, WRNORM
constexpr std::int16_t POLL_PRI = 2, POLL_ERROR = 8, POLL_HUNG_UP = 0x10, POLL_INVALID = 0x20;

}  // namespace

// Nanoseconds, LONGEST_NS where `address` is 0, or an error.
std::int64_t LinuxKernel::span_at(std::uint32_t address, Span kind) const {
    std::int64_t time[2];
    std::int32_t narrow[2];
    if (address == 0) return LONGEST_NS;
    if (kind == Span::TIMESPEC64 ? !memory().read(address, time, sizeof time)
                                 : !memory().read(address, narrow, sizeof narrow))
        return -EFAULT;
    if (kind != Span::TIMESPEC64) std::copy_n(narrow, 2, time);
    time[1] = static_cast<std::int32_t>(time[1]);  // what lies above is not set by all libraries
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
        memory().write(address, time, sizeof time);
    } else {
        give_time(address, ns, kind == Span::TIMESPEC64);
    }
}

// What a thread waits for that waits for this file, too.
void LinuxKernel::name_source(std::string& what, int fd) const {
    const std::string name = files().name(fd);
    if (what.find(name) == std::string::npos) what += (what.empty() ? "" : " or ") + name;
}

// Modules say anew what their files can do.
void LinuxKernel::poll_again() {
    for (const auto& process : processes_)
        process->files.for_each_device([](LinuxDevice& device) { device.look_again(); });
}

void LinuxKernel::poll_module(ModuleFile& file) {
    ModuleRequest request{KMOD_POLL, file.id};
    request.finish = [this, open = file.weak_from_this()](std::int64_t events) {
        if (const auto still = open.lock()) still->polled(static_cast<std::uint32_t>(events));
        changed_ = true;
        return Result{0};
    };
    this->request(file.module, std::move(request), "");
}

// Nothing is ready: whether it waits longer, until `end_ns` or, where a module has still to say
// what a file can do, for that.
bool LinuxKernel::goes_on(LinuxWait& wait, bool unknown, std::uint64_t end_ns) const {
    wait.at_ns = unknown ? LinuxWait::NEVER : end_ns;
    return unknown || now_ns() < end_ns;
}

// ---- select: descriptors to read, to write and with exceptions, a bit each ----------------------

LinuxKernel::Result LinuxKernel::select(const Arguments& a, Span kind) {
    constexpr std::uint32_t MOST = 1024;
    if (static_cast<std::int32_t>(a[0]) < 0) return -EINVAL;
    const std::uint32_t count = std::min(a[0], MOST);
    const std::int64_t span = span_at(a[4], kind);
    if (span < 0) return span;
    std::array<std::vector<std::uint32_t>, 3> asked, ready;
    std::string what;
    for (unsigned set = 0; set < 3; ++set) {
        asked[set].resize((count + 31) / 32);
        const std::size_t bytes = 4 * asked[set].size();
        if (a[1 + set] && bytes && !memory().read(a[1 + set], asked[set].data(), bytes))
            return -EFAULT;
        if (count % 32) asked[set].back() &= (1u << count % 32) - 1;
        for (std::uint32_t fd = 0; fd < count; ++fd) {
            if (!(asked[set][fd / 32] >> fd % 32 & 1)) continue;
            if (files().flags(static_cast<int>(fd)) < 0) return -EBADF;
            name_source(what, static_cast<int>(fd));
        }
    }
    if (kind != Span::TIMEVAL && a[5] != 0) {
        std::uint32_t mask[2];
        if (!memory().read(a[5], mask, sizeof mask)) return -EFAULT;
        if (const std::int64_t error = mask_meanwhile(mask[0], mask[1])) return error;
    }
    poll_again();
    LinuxWait wait;
    wait.what = what.empty() ? "the time to wake up" : what;
    wait.at_ns = a[4] == 0 ? LinuxWait::NEVER : later_ns(static_cast<std::uint64_t>(span));
    const std::uint64_t end_ns = wait.at_ns;
    const auto give_left = [this, to = a[4], kind, end_ns] {
        if (to == 0) return;
        const std::uint64_t now = now_ns();
        give_span(to, kind, end_ns > now ? end_ns - now : 0);
    };
    wait.look = [this, a, count, asked, ready, give_left, end_ns](LinuxWait& w) mutable -> Result {
        std::int64_t found = 0;
        bool unknown = false;
        ready = asked;
        for (std::uint32_t fd = 0; fd < count; ++fd) {
            const bool is_asked =
                (asked[0][fd / 32] | asked[1][fd / 32] | asked[2][fd / 32]) >> fd % 32 & 1;
            const unsigned can = is_asked ? files().can_do(static_cast<int>(fd)) : 0;
            unknown |= (can & LinuxFiles::UNKNOWN) != 0;
            constexpr unsigned READY[3] = {LinuxFiles::READ | LinuxFiles::HUNG_UP,
                                           LinuxFiles::WRITE | LinuxFiles::BROKEN,
                                           LinuxFiles::PRIORITY};
            for (const unsigned set : {0u, 1u, 2u}) {
                std::uint32_t& word = ready[set][fd / 32];
                if (!(can & READY[set])) word &= ~(1u << fd % 32);
                found += word >> fd % 32 & 1;
            }
        }
        if (found == 0 && goes_on(w, unknown, end_ns)) return std::nullopt;
        for (unsigned set = 0; set < 3; ++set)
            if (a[1 + set] && count)
                memory().write(a[1 + set], ready[set].data(), 4 * ready[set].size());
        give_left();
        return found;
    };
    return this->wait(std::move(wait));
}

LinuxKernel::Result LinuxKernel::sys_select(const Arguments& a) { return select(a, Span::TIMEVAL); }
LinuxKernel::Result LinuxKernel::sys_pselect6(const Arguments& a) {
    return select(a, Span::TIMESPEC);
}
LinuxKernel::Result LinuxKernel::sys_pselect6_time64(const Arguments& a) {
    return select(a, Span::TIMESPEC64);
}

// ---- poll: a list of descriptors ----------------------------------------------------------------

LinuxKernel::Result LinuxKernel::poll(std::uint32_t list, std::uint32_t count,
                                      std::int64_t span_ns) {
    constexpr std::uint32_t MOST = 1024;
    if (span_ns < 0) return span_ns;
    if (count > MOST) return -EINVAL;
    std::vector<PollEntry> entries(count);
    const std::size_t bytes = count * sizeof(PollEntry);
    if (count && !memory().read(list, entries.data(), bytes)) return -EFAULT;
    std::string what;
    for (const PollEntry& entry : entries)
        if (files().flags(entry.fd) >= 0) name_source(what, entry.fd);
    poll_again();
    LinuxWait wait;
    wait.what = what.empty() ? "the time to wake up" : what;
    wait.at_ns = span_ns >= static_cast<std::int64_t>(LONGEST_NS)
                     ? LinuxWait::NEVER
                     : later_ns(static_cast<std::uint64_t>(span_ns));
    wait.look = [this, list, entries, bytes, end_ns = wait.at_ns](LinuxWait& w) mutable -> Result {
        std::int64_t found = 0;
        bool unknown = false;
        for (PollEntry& e : entries) {
            e.found = 0;
            if (e.fd < 0) continue;
            const unsigned can = files().can_do(e.fd);
            unknown |= (can & LinuxFiles::UNKNOWN) != 0;
            const int allowed = (can & LinuxFiles::READ ? POLL_IN : 0) |
                                (can & LinuxFiles::PRIORITY ? POLL_PRI : 0) |
                                (can & LinuxFiles::WRITE ? POLL_OUT : 0);
            e.found = static_cast<std::int16_t>((e.events & allowed) |
                                                (can & LinuxFiles::HUNG_UP ? POLL_HUNG_UP : 0) |
                                                (can & LinuxFiles::BROKEN ? POLL_ERROR : 0));
            if (files().flags(e.fd) < 0) e.found = POLL_INVALID;
            found += e.found != 0;
        }
        if (found == 0 && goes_on(w, unknown, end_ns)) return std::nullopt;
        if (!entries.empty() && !memory().write(list, entries.data(), bytes)) return -EFAULT;
        return found;
    };
    return this->wait(std::move(wait));
}

LinuxKernel::Result LinuxKernel::sys_poll(const Arguments& a) {
    const auto ms = static_cast<std::int32_t>(a[2]);
    return poll(a[0], a[1], ms < 0 ? static_cast<std::int64_t>(LONGEST_NS) : ms * 1'000'000LL);
}
LinuxKernel::Result LinuxKernel::sys_ppoll(const Arguments& a) {
    const std::int64_t error = mask_meanwhile(a[3], a[4]);
    return error ? error : poll(a[0], a[1], span_at(a[2], Span::TIMESPEC));
}
LinuxKernel::Result LinuxKernel::sys_ppoll_time64(const Arguments& a) {
    const std::int64_t error = mask_meanwhile(a[3], a[4]);
    return error ? error : poll(a[0], a[1], span_at(a[2], Span::TIMESPEC64));
}

// ---- epoll: a list that is kept -----------------------------------------------------------------

LinuxKernel::Result LinuxKernel::sys_epoll_create(const Arguments& a) {
    return static_cast<std::int32_t>(a[0]) <= 0 ? -EINVAL : sys_epoll_create1({});
}

LinuxKernel::Result LinuxKernel::sys_epoll_create1(const Arguments& a) {
    if (a[0] & ~arm_open::CLOEXEC) return -EINVAL;
    return files().add(
        std::make_shared<LinuxEpoll>([this]() -> const LinuxFiles& { return files(); }), a[0]);
}

LinuxKernel::Result LinuxKernel::sys_epoll_ctl(const Arguments& a) {
    const int fd = static_cast<int>(a[0]);
    if (files().flags(fd) < 0) return -EBADF;
    auto* const epoll = dynamic_cast<LinuxEpoll*>(files().device(fd));
    if (!epoll) return -EINVAL;
    LinuxEpoll::Event event{};
    if (a[1] != LinuxEpoll::DELETE && !memory().read(a[3], &event, sizeof event)) return -EFAULT;
    return epoll->change(a[1], static_cast<int>(a[2]), event);
}

LinuxKernel::Result LinuxKernel::sys_epoll_wait(const Arguments& a) {
    const int fd = static_cast<int>(a[0]);
    constexpr std::uint32_t MOST = 0x7FFFFFFF / sizeof(LinuxEpoll::Event);
    if (a[2] == 0 || a[2] > MOST) return -EINVAL;
    if (files().flags(fd) < 0) return -EBADF;
    auto* const epoll = dynamic_cast<LinuxEpoll*>(files().device(fd));
    if (!epoll) return -EINVAL;
    const auto ms = static_cast<std::int32_t>(a[3]);
    poll_again();
    LinuxWait wait;
    wait.what = epoll->waits_for();
    wait.at_ns = ms < 0 ? LinuxWait::NEVER : later_ns(static_cast<std::uint64_t>(ms) * 1'000'000);
    wait.look = [this, epoll, open = files().hold(fd), to = a[1], most = a[2],
                 end_ns = wait.at_ns](LinuxWait& w) -> Result {
        const std::vector<LinuxEpoll::Event> events = epoll->take(most);
        if (events.empty()) return goes_on(w, epoll->is_unknown(), end_ns) ? Result{} : Result{0};
        const bool written =
            memory().write(to, events.data(), events.size() * sizeof(LinuxEpoll::Event));
        return written ? static_cast<std::int64_t>(events.size()) : -EFAULT;
    };
    return this->wait(std::move(wait));
}

LinuxKernel::Result LinuxKernel::sys_epoll_pwait(const Arguments& a) {
    const std::int64_t error = mask_meanwhile(a[4], a[5]);
    return error ? error : sys_epoll_wait(a);
}

}  // namespace sim
