// kernel_ipc_messages.cpp - LinuxKernel's calls for message queues of System V
#include <algorithm>
#include <cerrno>

#include "sim/linux/ipc.h"
#include "sim/linux/kernel.h"

namespace sim {

LinuxKernel::Result LinuxKernel::sys_msgget(const Arguments& a) {
    IpcMessages made{a[0], a[1] & ipc::RIGHTS};
    made.changed_ns = now_ns();
    return ipc::find_or_make(ipc_messages_, next_ipc_, a[0], a[1], made, true);
}

// struct msgbuf is a type, and then the bytes.
LinuxKernel::Result LinuxKernel::sys_msgsnd(const Arguments& a) {
    std::int32_t type;
    const int number = static_cast<int>(a[0]);
    if (!memory().read(a[1], &type, sizeof type)) return -EFAULT;
    if (a[2] > IpcMessages::LONGEST || number < 0 || type < 1) return -EINVAL;
    IpcMessages::Message message{type, std::vector<std::uint8_t>(a[2])};
    if (!memory().read(a[1] + 4, message.bytes.data(), a[2])) return -EFAULT;
    if (!ipc_messages_.count(number)) return -EINVAL;
    LinuxWait wait;
    wait.what = "room in a message queue";
    wait.inside = true;
    wait.look = [this, number, message, flags = a[3], place = WaitingLine::Place{},
                 own = process_->number](LinuxWait&) mutable -> Result {
        const auto found = ipc_messages_.find(number);
        if (found == ipc_messages_.end()) return -EIDRM;
        IpcMessages& queue = found->second;
        const std::size_t size = message.bytes.size();
        if (!queue.has_room(size) || !queue.senders.has_turn(place)) {
            if (flags & ipc::NO_WAIT) return -EAGAIN;
            if (!place) place = queue.senders.join([&queue, size] { return queue.has_room(size); });
            return std::nullopt;
        }
        queue.messages.push_back(std::move(message));
        queue.senders.forget_gone();
        queue.bytes += static_cast<std::uint32_t>(size);
        queue.sent_ns = now_ns();
        queue.sender = own;
        changed_ = true;
        return 0;
    };
    return this->wait(std::move(wait));
}

LinuxKernel::Result LinuxKernel::sys_msgrcv(const Arguments& a) {
    constexpr std::uint32_t CUT = 010000, BUT_NOT = 020000, COPY = 040000;
    const int number = static_cast<int>(a[0]);
    const std::uint32_t flags = a[4];
    if (number < 0 || static_cast<std::int32_t>(a[2]) < 0) return -EINVAL;
    if (flags & COPY) {  // which the board's kernel is configured without
        if ((flags & BUT_NOT) || !(flags & ipc::NO_WAIT)) return -EINVAL;
        return -ENOSYS;
    }
    if (!ipc_messages_.count(number)) return -EINVAL;
    const IpcMessages::Choice choice{static_cast<std::int32_t>(a[3]), (flags & BUT_NOT) != 0};
    LinuxWait wait;
    wait.what = "a message";
    wait.inside = true;
    wait.look = [this, number, choice, flags, to = a[1], most = a[2], place = WaitingLine::Place{},
                 own = process_->number](LinuxWait&) mutable -> Result {
        const auto found = ipc_messages_.find(number);
        if (found == ipc_messages_.end()) return -EIDRM;
        IpcMessages& queue = found->second;
        const auto first = queue.find(choice);
        if (first == queue.messages.end() || !queue.receivers.has_turn(place)) {
            if (flags & ipc::NO_WAIT) return -ENOMSG;
            if (!place)
                place = queue.receivers.join(
                    [&queue, choice] { return queue.find(choice) != queue.messages.end(); });
            return std::nullopt;
        }
        changed_ = true;  // another that waits may take it
        const auto size = static_cast<std::uint32_t>(first->bytes.size());
        if (size > most && !(flags & CUT)) return -E2BIG;
        const IpcMessages::Message message = std::move(*first);
        queue.messages.erase(first);
        queue.receivers.forget_gone();
        queue.bytes -= size;
        queue.received_ns = now_ns();
        queue.receiver = own;
        const std::uint32_t count = std::min(size, most);
        const bool given = memory().write(to, &message.type, sizeof message.type) &&
                           memory().write(to + 4, message.bytes.data(), count);
        return given ? std::int64_t{count} : -EFAULT;
    };
    return this->wait(std::move(wait));
}

LinuxKernel::Result LinuxKernel::sys_msgctl(const Arguments& a) {
    struct {  // struct msqid64_ds
        ipc::Rights rights;
        std::uint32_t sent[2], received[2], changed[2], bytes, messages, most_bytes, sender,
            receiver, unused[2];
    } all{};
    static_assert(sizeof all == 88);
    const std::uint32_t command = a[1] & ~ipc::NEW_LAYOUT;
    const bool changes = command == ipc::CHANGE;
    if (!changes && command != ipc::REMOVE && command != ipc::STATUS) return -EINVAL;
    if (changes && !memory().read(a[2], &all, sizeof all)) return -EFAULT;
    const auto found = ipc_messages_.find(static_cast<int>(a[0]));
    if (found == ipc_messages_.end()) return -EINVAL;
    IpcMessages& queue = found->second;
    changed_ = true;
    if (command == ipc::REMOVE) {
        ipc_messages_.erase(found);
        return 0;
    }
    if (changes) {
        queue.rights = all.rights.mode & ipc::RIGHTS;
        queue.most_bytes = all.most_bytes;
        queue.changed_ns = now_ns();
        return 0;
    }
    const auto seconds = [](std::uint64_t ns) { return static_cast<std::uint32_t>(ns / NS); };
    all.rights.key = static_cast<std::int32_t>(queue.key);
    all.rights.mode = static_cast<std::uint16_t>(queue.rights);
    all.sent[0] = seconds(queue.sent_ns);
    all.received[0] = seconds(queue.received_ns);
    all.changed[0] = seconds(queue.changed_ns);
    all.bytes = queue.bytes;
    all.messages = static_cast<std::uint32_t>(queue.messages.size());
    all.most_bytes = queue.most_bytes;
    all.sender = static_cast<std::uint32_t>(queue.sender);
    all.receiver = static_cast<std::uint32_t>(queue.receiver);
    return memory().write(a[2], &all, sizeof all) ? 0 : -EFAULT;
}

}  // namespace sim
