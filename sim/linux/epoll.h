// epoll.h - an open file of epoll: which open files it watches, and what is ready of them.
//
// Source: epoll(7), epoll_ctl(2).
//
// Not handled: EPOLLEXCLUSIVE and EPOLLWAKEUP have no effect; with EPOLLET, more input of the
// console or /dev/input/mice is no new event while there is some.
#pragma once

#include <cerrno>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/linux/files.h"

namespace sim {

class LinuxEpoll final : public LinuxDevice {
public:
    static constexpr std::uint32_t IN = 1, PRI = 2, OUT = 4, BROKEN = 8, HUNG_UP = 0x10,
                                   IN_NORMAL = 0x40, OUT_NORMAL = 0x100, ONE_SHOT = 1u << 30,
                                   EDGE = 1u << 31;
    enum Operation : std::uint32_t { ADD = 1, DELETE = 2, MODIFY = 3 };

    struct Event {  // as the program has it
        std::uint32_t events, pad;
        std::uint64_t data;
    };

    explicit LinuxEpoll(std::function<const LinuxFiles&()> files) : files_{std::move(files)} {}

    std::int64_t change(std::uint32_t operation, int fd, const Event& event) {
        forget_closed();
        const LinuxFiles& files = files_();
        if (files.flags(fd) < 0) return -EBADF;
        if (files.device(fd) == this) return -EINVAL;
        if (!files.device(fd) && !files.is_console(fd)) return -EPERM;
        const auto watch = watches_.find(fd);
        const bool is_there = watch != watches_.end();
        switch (operation) {
            case ADD:
                if (is_there) return -EEXIST;
                if (const auto* other = dynamic_cast<const LinuxEpoll*>(files.device(fd)))
                    if (other->watches(*this)) return -ELOOP;
                watches_[fd] = {files.hold(fd), event, 0, 0};
                return 0;
            case MODIFY:
                if (!is_there) return -ENOENT;
                watch->second = {files.hold(fd), event, 0, 0};
                return 0;
            case DELETE:
                if (!is_there) return -ENOENT;
                watches_.erase(watch);
                return 0;
            default: return -EINVAL;
        }
    }

    // Those that are ready, `most` of them, which takes them with ONE_SHOT and EDGE.
    std::vector<Event> take(std::size_t most) {
        forget_closed();
        std::vector<Event> all;
        for (auto& [fd, watch] : watches_) {
            if (all.size() == most) break;
            const std::uint32_t events = news(fd, watch);
            watch.seen = ready(fd, watch);
            watch.arrivals = arrivals_of(fd);
            if (events == 0) continue;
            all.push_back({events, 0, watch.event.data});
            if (watch.event.events & ONE_SHOT) watch.event.events &= EDGE | ONE_SHOT;
        }
        return all;
    }

    // What it waits for, in a message.
    std::string waits_for() const {
        std::string all;
        const Visit visit{*this};
        if (!visit.is_first) return all;
        for (const auto& [fd, watch] : watches_) {
            if (!is_open(fd, watch)) continue;
            const std::string name = files_().name(fd);
            if (all.find(name) == std::string::npos) all += (all.empty() ? "" : " or ") + name;
        }
        return all.empty() ? "the time to wake up" : all;
    }

    // What a file can do is not known yet.
    bool is_unknown() const {
        const Visit visit{*this};
        if (!visit.is_first) return false;
        for (const auto& [fd, watch] : watches_)
            if (is_open(fd, watch) && files_().can_do(fd) & UNKNOWN) return true;
        return false;
    }

    FileStatus status() const override { return {0600, 0, 1, 0}; }
    std::string name() const override { return waits_for(); }
    unsigned can_do() const override {
        const Visit visit{*this};
        if (!visit.is_first) return 0;
        for (const auto& [fd, watch] : watches_)
            if (is_open(fd, watch) && news(fd, watch) != 0) return READ;
        return 0;
    }

private:
    struct Watch {
        std::weak_ptr<void> file;
        Event event;
        // When it was looked at last:
        std::uint32_t seen;
        std::uint64_t arrivals;
    };

    // Its number may be another file's by now.
    bool is_open(int fd, const Watch& watch) const {
        return !watch.file.expired() && watch.file.lock() == files_().hold(fd);
    }

    // ADD refuses a ring of files that watch each other.  A process whose numbers differ from those
    // by which they were added may still close one, so a file is visited once.
    struct Visit {
        explicit Visit(const LinuxEpoll& of)
            : epoll{of}, is_first{!std::exchange(of.is_visited_, true)} {}
        ~Visit() { epoll.is_visited_ = !is_first; }
        const LinuxEpoll& epoll;
        const bool is_first;
    };

    bool watches(const LinuxEpoll& wanted) const {
        const Visit visit{*this};
        if (!visit.is_first) return false;
        for (const auto& [fd, watch] : watches_) {
            if (!is_open(fd, watch)) continue;
            const auto* const other = dynamic_cast<const LinuxEpoll*>(files_().device(fd));
            if (other && (other == &wanted || other->watches(wanted))) return true;
        }
        return false;
    }

    std::uint32_t ready(int fd, const Watch& watch) const {
        const unsigned can = files_().can_do(fd);
        const std::uint32_t all =
            (can & READ ? IN | IN_NORMAL : 0) | (can & WRITE ? OUT | OUT_NORMAL : 0) |
            (can & LinuxDevice::HUNG_UP ? HUNG_UP : 0) | (can & LinuxDevice::BROKEN ? BROKEN : 0) |
            (can & PRIORITY ? PRI : 0);
        const bool asked = watch.event.events & ~(EDGE | ONE_SHOT);
        return asked ? all & (watch.event.events | HUNG_UP | BROKEN) : 0;
    }
    std::uint64_t arrivals_of(int fd) const {
        const LinuxDevice* const device = files_().device(fd);
        return device ? device->arrivals() : 0;
    }
    // With EDGE only if something has come since.
    std::uint32_t news(int fd, const Watch& watch) const {
        const std::uint32_t now = ready(fd, watch);
        const bool is_new = now & ~watch.seen || arrivals_of(fd) != watch.arrivals;
        return !(watch.event.events & EDGE) || is_new ? now : 0;
    }

    void forget_closed() {
        for (auto watch = watches_.begin(); watch != watches_.end();)
            watch = is_open(watch->first, watch->second) ? std::next(watch) : watches_.erase(watch);
    }

    std::function<const LinuxFiles&()> files_;
    std::map<int, Watch> watches_;
    mutable bool is_visited_ = false;
};

}  // namespace sim
