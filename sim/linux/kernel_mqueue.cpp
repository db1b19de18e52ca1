// kernel_mqueue.cpp - LinuxKernel's calls for POSIX message queues
#include <cerrno>
#include <csignal>

#include "sim/linux/arm_abi.h"
#include "sim/linux/kernel.h"

namespace sim {

namespace {

struct QueueAttributes {  // struct mq_attr
    std::int32_t flags, most, most_bytes, messages, unused[4];
};
static_assert(sizeof(QueueAttributes) == 32);

}  // namespace

LinuxKernel::Result LinuxKernel::sys_mq_open(const Arguments& a) {
    QueueAttributes asked{};
    if (a[3] != 0 && !memory().read(a[3], &asked, sizeof asked)) return -EFAULT;
    const auto name = memory().string(a[0]);
    if (!name) return -EFAULT;
    const MessageQueues::Limits limits{asked.most, asked.most_bytes};
    const std::uint32_t mode = a[2] & 07777 & ~process_->umask;
    const auto [error, queue] =
        message_queues_.open(*name, a[1], mode, a[3] != 0 ? &limits : nullptr);
    if (error) return error;
    const std::uint32_t access = a[1] & arm_open::ACCESS;
    const bool reads = access == arm_open::RDONLY || access == arm_open::RDWR;
    return files().add(std::make_shared<MessageQueueFile>(queue, reads),
                       access | (a[1] & arm_open::NONBLOCK) | arm_open::CLOEXEC);
}

LinuxKernel::Result LinuxKernel::sys_mq_unlink(const Arguments& a) {
    const auto name = memory().string(a[0]);
    return name ? message_queues_.unlink(*name) : -EFAULT;
}

// Of an open file, which must have been opened for `access` if there is one; or nullptr.
std::shared_ptr<MessageQueue> LinuxKernel::message_queue(
    std::uint32_t fd, std::optional<std::uint32_t> access) const {
    const int number = static_cast<int>(fd);
    const auto* const file = dynamic_cast<MessageQueueFile*>(files().device(number));
    if (!file) return nullptr;
    const std::uint32_t has = static_cast<std::uint32_t>(files().flags(number)) & arm_open::ACCESS;
    return !access || has == *access || has == arm_open::RDWR ? file->queue : nullptr;
}

// Until an absolute time of CLOCK_REALTIME, or for ever where `address` is 0; or an error.
std::int64_t LinuxKernel::end_of_wait(std::uint32_t address, Span kind, LinuxWait& wait) const {
    if (address == 0) {
        wait.inside = true;
        return 0;
    }
    const std::int64_t end = span_at(address, kind);
    if (end < 0) return end;
    wait.at_ns = static_cast<std::uint64_t>(end);
    return 0;
}

LinuxKernel::Result LinuxKernel::mq_send(const Arguments& a, Span kind) {
    constexpr std::uint32_t PRIORITIES = 32768;
    LinuxWait wait;
    if (const std::int64_t error = end_of_wait(a[4], kind, wait)) return error;
    if (a[3] >= PRIORITIES) return -EINVAL;
    const auto queue = message_queue(a[0], arm_open::WRONLY);
    if (!queue) return -EBADF;
    if (a[2] > queue->most_bytes) return -EMSGSIZE;
    MessageQueue::Bytes bytes(a[2]);
    if (!memory().read(a[1], bytes.data(), bytes.size())) return -EFAULT;
    const bool returns = does_not_wait(a[0]);
    wait.what = "room in a message queue";
    wait.restarts = true;
    wait.look = [this, queue, returns, bytes, priority = a[3],
                 place = WaitingLine::Place{}](LinuxWait& w) mutable -> Result {
        if (queue->is_full() || !queue->senders.has_turn(place)) {
            if (returns) return -EAGAIN;
            if (now_ns() >= w.at_ns) return -ETIMEDOUT;
            if (!place) place = queue->senders.join([q = queue.get()] { return !q->is_full(); });
            return std::nullopt;
        }
        queue->messages.emplace(priority, bytes);
        queue->senders.forget_gone();
        ++queue->changes;
        changed_ = true;
        if (queue->messages.size() == 1 && queue->receivers.size() == 0) notify_of(*queue);
        return 0;
    };
    return this->wait(std::move(wait));
}

LinuxKernel::Result LinuxKernel::mq_receive(const Arguments& a, Span kind) {
    LinuxWait wait;
    if (const std::int64_t error = end_of_wait(a[4], kind, wait)) return error;
    const auto queue = message_queue(a[0], arm_open::RDONLY);
    if (!queue) return -EBADF;
    if (a[2] < queue->most_bytes) return -EMSGSIZE;
    const bool returns = does_not_wait(a[0]);
    wait.what = "a message";
    wait.restarts = true;
    wait.look = [this, queue, returns, to = a[1], priority_to = a[3],
                 place = WaitingLine::Place{}](LinuxWait& w) mutable -> Result {
        if (queue->messages.empty() || !queue->receivers.has_turn(place)) {
            if (returns) return -EAGAIN;
            if (now_ns() >= w.at_ns) return -ETIMEDOUT;
            if (!place)
                place = queue->receivers.join([q = queue.get()] { return !q->messages.empty(); });
            return std::nullopt;
        }
        const auto first = queue->messages.begin();
        const auto [priority, bytes] = *first;
        queue->messages.erase(first);
        queue->receivers.forget_gone();
        ++queue->changes;
        changed_ = true;
        const bool given =
            (priority_to == 0 || memory().write(priority_to, &priority, sizeof priority)) &&
            memory().write(to, bytes.data(), bytes.size());
        return given ? static_cast<std::int64_t>(bytes.size()) : -EFAULT;
    };
    return this->wait(std::move(wait));
}

LinuxKernel::Result LinuxKernel::sys_mq_timedsend(const Arguments& a) {
    return mq_send(a, Span::TIMESPEC);
}
LinuxKernel::Result LinuxKernel::sys_mq_timedsend_time64(const Arguments& a) {
    return mq_send(a, Span::TIMESPEC64);
}
LinuxKernel::Result LinuxKernel::sys_mq_timedreceive(const Arguments& a) {
    return mq_receive(a, Span::TIMESPEC);
}
LinuxKernel::Result LinuxKernel::sys_mq_timedreceive_time64(const Arguments& a) {
    return mq_receive(a, Span::TIMESPEC64);
}

// ---- Who is told of a message -------------------------------------------------------------------

// It is told once.
void LinuxKernel::notify_of(MessageQueue& queue) {
    LinuxProcess* const owner = queue.owner != 0 ? process_of(queue.owner) : nullptr;
    queue.owner = 0;
    if (!owner || queue.notify != SIGEV_SIGNAL || queue.signal == 0) return;
    send(*owner, {queue.signal,
                  arm_signal_code::MESSAGE,
                  {static_cast<std::uint32_t>(process_->number), 0, queue.value},
                  "a message came,"});
}

LinuxKernel::Result LinuxKernel::sys_mq_notify(const Arguments& a) {
    struct {
        std::uint32_t value, signal, notify, rest[13];
    } event;
    static_assert(sizeof event == 64);
    if (a[1] != 0) {
        if (!memory().read(a[1], &event, sizeof event)) return -EFAULT;
        if (event.notify > SIGEV_THREAD) return -EINVAL;
        if (event.notify == SIGEV_SIGNAL && event.signal > LinuxSignals::COUNT) return -EINVAL;
        if (event.notify == SIGEV_THREAD) {  // by a socket of netlink
            not_emulated("mq_notify with SIGEV_THREAD");
            return -ENOSYS;
        }
    }
    const auto queue = message_queue(a[0], {});
    if (!queue) return -EBADF;
    const int own = process_->number;
    if (a[1] == 0) {
        if (queue->owner == own) queue->owner = 0;
        return 0;
    }
    if (queue->owner != 0) return -EBUSY;
    queue->owner = own;
    queue->notify = event.notify;
    queue->signal = event.signal;
    queue->value = event.value;
    return 0;
}

// As a file is closed.
void LinuxKernel::forget_notice(std::uint32_t fd) {
    if (const auto queue = message_queue(fd, {}))
        message_queues_.forget_owner(process_->number, queue.get());
}

LinuxKernel::Result LinuxKernel::sys_mq_getsetattr(const Arguments& a) {
    constexpr std::int32_t NONBLOCK = static_cast<std::int32_t>(arm_open::NONBLOCK);
    QueueAttributes to{};
    if (a[1] != 0) {
        if (!memory().read(a[1], &to, sizeof to)) return -EFAULT;
        if (to.flags & ~NONBLOCK) return -EINVAL;
    }
    const auto queue = message_queue(a[0], {});
    if (!queue) return -EBADF;
    const int fd = static_cast<int>(a[0]);
    const QueueAttributes now{files().flags(fd) & NONBLOCK,
                              static_cast<std::int32_t>(queue->most),
                              static_cast<std::int32_t>(queue->most_bytes),
                              static_cast<std::int32_t>(queue->messages.size()),
                              {}};
    if (a[1] != 0) files().set_flags(fd, static_cast<std::uint32_t>(to.flags));
    return a[2] == 0 || memory().write(a[2], &now, sizeof now) ? 0 : -EFAULT;
}

}  // namespace sim
