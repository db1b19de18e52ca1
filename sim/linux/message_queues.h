// message_queues.h - POSIX message queues: names and limits, messages by priority, open files.
//
// A message that somebody waits for is that thread's at once: nobody else sees it.
//
// Source: Linux 6.1, ipc/mqueue.c; mq_overview(7).
//
// Not handled: the folder /dev/mqueue; notices by SIGEV_THREAD, which need netlink.
#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/linux/device.h"
#include "sim/linux/waiting_line.h"

namespace sim {

struct MessageQueue {
    using Bytes = std::vector<std::uint8_t>;

    std::uint32_t most = 10, most_bytes = 8192;  // messages; bytes of one
    std::uint32_t mode = 0;
    std::uint64_t number = 0;                                        // its inode
    std::multimap<std::uint32_t, Bytes, std::greater<>> messages{};  // by their priorities
    WaitingLine receivers{}, senders{};
    std::uint64_t changes = 0;
    // The process that gets a signal when a message comes into an empty queue; 0: none.
    int owner = 0;
    std::uint32_t notify = 0, signal = 0, value = 0;  // as in sigevent

    // What Linux counts for it.
    std::uint64_t cost() const;
    bool is_full() const { return messages.size() >= most; }
};

class MessageQueueFile final : public LinuxDevice {
public:
    MessageQueueFile(std::shared_ptr<MessageQueue> to, bool reads)
        : queue{std::move(to)}, reads_{reads} {}

    const std::shared_ptr<MessageQueue> queue;

    FileStatus status() const override;
    std::string name() const override { return "a message queue"; }
    bool is_inside() const override { return true; }
    unsigned can_do() const override;
    std::uint64_t arrivals() const override { return queue->changes; }
    // How many bytes there are, and who is notified, as a text.
    std::int64_t read(void* data, std::size_t bytes) override;

private:
    bool reads_;
    std::size_t at_ = 0;  // in the text
};

class MessageQueues {
public:
    static constexpr std::uint64_t ALL_BYTES = 819200;  // RLIMIT_MSGQUEUE

    struct Limits {  // that mq_open() asks for
        std::int32_t most, most_bytes;
    };
    // By its name without the slash, or with `limits`, unless nullptr, a new one.
    std::pair<int, std::shared_ptr<MessageQueue>> open(const std::string& name, std::uint32_t flags,
                                                       std::uint32_t mode, const Limits* limits);
    int unlink(const std::string& name);
    // The process has closed one of its files of `only`, or for nullptr all of its files.
    void forget_owner(int process, const MessageQueue* only);

private:
    static int check_name(const std::string& name);

    std::map<std::string, std::shared_ptr<MessageQueue>> by_name_;
    std::list<std::weak_ptr<MessageQueue>> all_;
    std::uint64_t made_ = 0;
};

}  // namespace sim
