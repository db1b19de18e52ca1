// uevents.h - what the kernel tells about devices that come and go, by sockets of netlink
//
// A socket of NETLINK_KOBJECT_UEVENT that is bound to group 1, the kernel's, receives them from
// then on.
//
// Source: Linux 6.1, lib/kobject_uevent.c; netlink(7).
//
// Not handled: group 2, of udev, which does not run; other devices than those on USB.
#pragma once

#include <sys/stat.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/linux/device.h"

namespace sim {

class UeventSocket final : public LinuxDevice {
public:
    FileStatus status() const override { return {S_IFSOCK | 0777, 0, 1, 0}; }
    std::string name() const override { return "a device that comes or goes"; }
    unsigned can_do() const override { return (messages_.empty() ? 0 : READ) | WRITE; }
    std::uint64_t arrivals() const override { return arrivals_; }
    std::int64_t write(const void*, std::size_t) override { return -ECONNREFUSED; }
    std::int64_t read(void* data, std::size_t bytes) override {
        if (messages_.empty()) return -EAGAIN;
        const std::size_t count = std::min(bytes, messages_.front().size());
        std::copy_n(messages_.front().begin(), count, static_cast<char*>(data));
        messages_.pop_front();
        return static_cast<std::int64_t>(count);
    }

    std::size_t next_bytes() const { return messages_.empty() ? 0 : messages_.front().size(); }
    void add(const std::string& message) {
        messages_.push_back(message);
        ++arrivals_;
    }

    std::uint32_t groups = 0;  // a bit each
    bool tells_who = false;    // SO_PASSCRED

private:
    std::deque<std::string> messages_;
    std::uint64_t arrivals_ = 0;
};

class UeventGroup {
public:
    void join(const std::shared_ptr<UeventSocket>& socket) { sockets_.push_back(socket); }
    // Fields that end with 0 each; the number of the message comes last.
    void tell(std::string message) {
        message += "SEQNUM=" + std::to_string(++number_) + '\0';
        for (const auto& socket : sockets_)
            if (const auto one = socket.lock(); one && (one->groups & KERNEL)) one->add(message);
        sockets_.erase(std::remove_if(sockets_.begin(), sockets_.end(),
                                      [](const auto& socket) { return socket.expired(); }),
                       sockets_.end());
    }

private:
    static constexpr std::uint32_t KERNEL = 1;

    std::vector<std::weak_ptr<UeventSocket>> sockets_;
    std::uint64_t number_ = 0;
};

}  // namespace sim
