#include "sim/linux/message_queues.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>

#include <fmt/format.h>

#include "sim/linux/arm_abi.h"

namespace sim {

namespace {

constexpr std::int32_t MOST_MESSAGES = 65536, MOST_MESSAGE_BYTES = 16 << 20;  // for user 0
constexpr std::size_t LONGEST_NAME = 255;

}  // namespace

// Of struct msg_msg each, and of the tree of priorities.
std::uint64_t MessageQueue::cost() const {
    constexpr std::uint64_t MESSAGE = 24, NODE = 24, PRIORITIES = 32768;
    return std::uint64_t{most} * (MESSAGE + most_bytes) +
           std::min<std::uint64_t>(most, PRIORITIES) * NODE;
}

// ---- An open file -------------------------------------------------------------------------------

FileStatus MessageQueueFile::status() const {
    constexpr std::uint64_t TEXT_BYTES = 80;
    return {S_IFREG | queue->mode, TEXT_BYTES, queue->number, 0};
}

unsigned MessageQueueFile::can_do() const {
    const bool readable = queue->messages.size() > queue->receivers.size();
    const bool writable = queue->messages.size() + queue->senders.size() < queue->most;
    return (readable ? READ : 0) | (writable ? WRITE : 0);
}

std::int64_t MessageQueueFile::read(void* data, std::size_t bytes) {
    if (!reads_) return -EBADF;
    std::size_t in_queue = 0;
    for (const auto& [priority, message] : queue->messages) in_queue += message.size();
    const bool by_signal = queue->owner != 0 && queue->notify == SIGEV_SIGNAL;
    const std::string text =
        fmt::format("QSIZE:{:<10} NOTIFY:{:<5} SIGNO:{:<5} NOTIFY_PID:{:<6}\n", in_queue,
                    queue->owner ? queue->notify : 0, by_signal ? queue->signal : 0, queue->owner);
    const std::size_t count = std::min(bytes, text.size() - std::min(at_, text.size()));
    std::memcpy(data, text.data() + at_, count);
    at_ += count;
    return static_cast<std::int64_t>(count);
}

// ---- By their names -----------------------------------------------------------------------------

int MessageQueues::check_name(const std::string& name) {
    if (name.empty()) return -ENOENT;
    if (name == "." || name == ".." || name.find('/') != std::string::npos) return -EACCES;
    return name.size() > LONGEST_NAME ? -ENAMETOOLONG : 0;
}

std::pair<int, std::shared_ptr<MessageQueue>> MessageQueues::open(const std::string& name,
                                                                  std::uint32_t flags,
                                                                  std::uint32_t mode,
                                                                  const Limits* limits) {
    if (const int error = check_name(name)) return {error, nullptr};
    const auto found = by_name_.find(name);
    if (found != by_name_.end()) {
        if ((flags & arm_open::CREAT) && (flags & arm_open::EXCL)) return {-EEXIST, nullptr};
        if ((flags & arm_open::ACCESS) == arm_open::ACCESS) return {-EINVAL, nullptr};
        return {0, found->second};
    }
    if (!(flags & arm_open::CREAT)) return {-ENOENT, nullptr};
    const auto made = std::make_shared<MessageQueue>();
    made->mode = mode;
    if (limits) {
        if (limits->most <= 0 || limits->most > MOST_MESSAGES || limits->most_bytes <= 0 ||
            limits->most_bytes > MOST_MESSAGE_BYTES)
            return {-EINVAL, nullptr};
        made->most = static_cast<std::uint32_t>(limits->most);
        made->most_bytes = static_cast<std::uint32_t>(limits->most_bytes);
        if (std::uint64_t{made->most} * made->most_bytes > UINT32_MAX) return {-EINVAL, nullptr};
    }
    all_.remove_if([](const auto& queue) { return queue.expired(); });
    std::uint64_t cost = made->cost();
    for (const auto& other : all_) cost += other.lock()->cost();
    if (cost > ALL_BYTES) return {-EMFILE, nullptr};
    made->number = ++made_;
    all_.push_back(made);
    by_name_.emplace(name, made);
    return {0, made};
}

int MessageQueues::unlink(const std::string& name) {
    if (const int error = check_name(name)) return error;
    return by_name_.erase(name) ? 0 : -ENOENT;
}

void MessageQueues::forget_owner(int process, const MessageQueue* only) {
    for (const auto& entry : all_) {
        const auto queue = entry.lock();
        if (queue && queue->owner == process && (!only || only == queue.get())) queue->owner = 0;
    }
}

}  // namespace sim
