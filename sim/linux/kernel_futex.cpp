// kernel_futex.cpp - LinuxKernel's futex: threads that wait for a word, and who wakes them
#include <algorithm>
#include <cerrno>
#include <csignal>

#include <fmt/format.h>

#include "sim/linux/kernel.h"

namespace sim {

namespace {

constexpr std::uint32_t FUTEX_WAIT = 0, FUTEX_WAKE = 1, FUTEX_REQUEUE = 3, FUTEX_CMP_REQUEUE = 4,
                        FUTEX_WAKE_OP = 5, FUTEX_WAIT_BITSET = 9, FUTEX_WAKE_BITSET = 10,
                        FUTEX_COMMAND = 0x7F, FUTEX_PRIVATE = 0x80;
constexpr std::uint32_t ANY_BITS = 0xFFFFFFFF;
constexpr std::uint32_t LOCK_OWNER_DIED = 0x40000000, LOCK_OWNER = 0x3FFFFFFF,
                        LOCK_WAITERS = 0x80000000;

// FUTEX_WAKE_OP's; no value: there is no such operation.
std::optional<std::uint32_t> changed_by(std::uint32_t operation, std::uint32_t old,
                                        std::uint32_t value) {
    switch (operation) {
        case 0: return value;
        case 1: return old + value;
        case 2: return old | value;
        case 3: return old & ~value;
        case 4: return old ^ value;
        default: return std::nullopt;
    }
}

std::optional<bool> compares(std::uint32_t comparison, std::uint32_t word, std::uint32_t other) {
    const auto a = static_cast<std::int32_t>(word), b = static_cast<std::int32_t>(other);
    switch (comparison) {
        case 0: return a == b;
        case 1: return a != b;
        case 2: return a < b;
        case 3: return a <= b;
        case 4: return a > b;
        case 5: return a >= b;
        default: return std::nullopt;
    }
}

// Of 12 bits.
std::uint32_t extended(std::uint32_t value) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(value << 20) >> 20);
}

}  // namespace

LinuxKernel::FutexKey LinuxKernel::futex_key(std::uint32_t address) const {
    const auto area = memory().at(address);
    if (area && area->second.shared)
        return {area->second.shared->identity(), area->second.physical_at(address - area->first)};
    return {&memory(), address};
}

std::int64_t LinuxKernel::futex_wake(const FutexKey& key, std::uint32_t most, std::uint32_t bits) {
    std::int64_t woken = 0;
    for (auto it = waiters_.begin(); it != waiters_.end() && woken < most;) {
        if (it->key != key || !(it->bits & bits)) {
            ++it;
            continue;
        }
        LinuxThread& thread = *it->thread;
        it = waiters_.erase(it);
        resume(thread, 0);
        ++woken;
    }
    return woken;
}

LinuxKernel::Result LinuxKernel::futex_wait(std::uint32_t address, std::uint32_t value,
                                            std::uint32_t bits, std::uint64_t end_ns) {
    std::uint32_t word;
    if (!memory().read(address, &word, sizeof word)) return -EFAULT;
    if (word != value) return -EAGAIN;
    LinuxWait wait;
    wait.inside = end_ns == LinuxWait::NEVER;
    wait.restarts = wait.inside;
    wait.at_ns = end_ns;
    wait.look = [this](LinuxWait& w) {
        return now_ns() >= w.at_ns ? Result{-ETIMEDOUT} : std::nullopt;
    };
    const Result result = this->wait(std::move(wait));
    if (!result) waiters_.push_back({running_, futex_key(address), bits, address});
    return result;
}

// Wakes some of those that wait at the first address; more of them wait at the other from now on.
LinuxKernel::Result LinuxKernel::futex_requeue(const Arguments& a, bool compare) {
    std::uint32_t word;
    if (static_cast<std::int32_t>(a[2]) < 0 || static_cast<std::int32_t>(a[3]) < 0) return -EINVAL;
    if (!memory().read(a[0], &word, sizeof word)) return -EFAULT;
    if (compare && word != a[5]) return -EAGAIN;
    const FutexKey from = futex_key(a[0]), to = futex_key(a[4]);
    std::int64_t count = futex_wake(from, a[2], ANY_BITS);
    std::list<FutexWaiter> moved;
    for (auto it = waiters_.begin(); it != waiters_.end() && moved.size() < a[3];) {
        const auto next = std::next(it);
        if (it->key == from) {
            it->key = to;
            moved.splice(moved.end(), waiters_, it);
        }
        it = next;
    }
    count += static_cast<std::int64_t>(moved.size());
    waiters_.splice(waiters_.end(), moved);
    return count;
}

LinuxKernel::Result LinuxKernel::futex_wake_op(const Arguments& a) {
    const std::uint32_t what = a[5];
    std::uint32_t old;
    if (!memory().read(a[4], &old, sizeof old)) return -EFAULT;
    std::uint32_t value = extended(what >> 12 & 0xFFF);
    if (what >> 31) value = 1u << (value & 31);
    const auto now = changed_by(what >> 28 & 7, old, value);
    const auto met = compares(what >> 24 & 0xF, old, extended(what & 0xFFF));
    if (!now || !met) return -ENOSYS;
    if (!memory().write(a[4], &*now, sizeof *now)) return -EFAULT;
    std::int64_t count = futex_wake(futex_key(a[0]), a[2], ANY_BITS);
    if (*met) count += futex_wake(futex_key(a[4]), a[3], ANY_BITS);
    return count;
}

LinuxKernel::Result LinuxKernel::futex(const Arguments& a, Span kind) {
    const std::uint32_t command = a[1] & FUTEX_COMMAND;
    if (a[0] % sizeof(std::uint32_t) != 0) return -EINVAL;
    std::uint64_t end_ns = LinuxWait::NEVER;
    if ((command == FUTEX_WAIT || command == FUTEX_WAIT_BITSET) && a[3] != 0) {
        const std::int64_t span = span_at(a[3], kind);
        if (span < 0) return span;
        end_ns = static_cast<std::uint64_t>(span);
        if (command == FUTEX_WAIT) end_ns = later_ns(end_ns);  // the other's is a time of the clock
    }
    const bool has_other = command == FUTEX_REQUEUE || command == FUTEX_CMP_REQUEUE;
    const auto is_readable = [this](std::uint32_t address) {
        return memory().bytes(address, sizeof(std::uint32_t), arm_access::READ) != nullptr;
    };
    if (!(a[1] & FUTEX_PRIVATE) && (!is_readable(a[0]) || (has_other && !is_readable(a[4]))))
        return -EFAULT;
    switch (command) {
        case FUTEX_WAIT: return futex_wait(a[0], a[2], ANY_BITS, end_ns);
        case FUTEX_WAIT_BITSET: return a[5] == 0 ? -EINVAL : futex_wait(a[0], a[2], a[5], end_ns);
        case FUTEX_WAKE: return futex_wake(futex_key(a[0]), std::max(a[2], 1u), ANY_BITS);
        case FUTEX_WAKE_BITSET:
            return a[5] == 0 ? -EINVAL : futex_wake(futex_key(a[0]), std::max(a[2], 1u), a[5]);
        case FUTEX_REQUEUE: return futex_requeue(a, false);
        case FUTEX_CMP_REQUEUE: return futex_requeue(a, true);
        case FUTEX_WAKE_OP: return futex_wake_op(a);
        default: not_emulated(fmt::format("futex, operation {}", command)); return -ENOSYS;
    }
}

LinuxKernel::Result LinuxKernel::sys_futex(const Arguments& a) { return futex(a, Span::TIMESPEC); }
LinuxKernel::Result LinuxKernel::sys_futex_time64(const Arguments& a) {
    return futex(a, Span::TIMESPEC64);
}

// ---- Locks of a thread that ends ----------------------------------------------------------------

LinuxKernel::Result LinuxKernel::sys_set_robust_list(const Arguments& a) {
    constexpr std::uint32_t HEAD = 12;
    if (a[1] != HEAD) return -EINVAL;
    running_->robust_list = a[0];
    return 0;
}

LinuxKernel::Result LinuxKernel::sys_get_robust_list(const Arguments& a) {
    constexpr std::uint32_t HEAD = 12;
    for (const LinuxThread* const thread : threads())
        if (a[0] == 0 ? thread == running_ : thread->number == static_cast<int>(a[0]))
            return memory().write(a[1], &thread->robust_list, sizeof HEAD) &&
                           memory().write(a[2], &HEAD, sizeof HEAD)
                       ? 0
                       : -EFAULT;
    return -ESRCH;
}

// The words of its robust mutexes say that their owner has died, and one that waits is woken.
void LinuxKernel::give_back_locks(const LinuxThread& thread) {
    constexpr unsigned MOST = 2048;
    struct {
        std::uint32_t next, offset, pending;
    } head;
    if (thread.robust_list == 0 || !memory().read(thread.robust_list, &head, sizeof head)) return;
    const auto give_back = [&](std::uint32_t entry) {
        const std::uint32_t address = (entry & ~1u) + head.offset;
        std::uint32_t word;
        if (!memory().read(address, &word, sizeof word) ||
            (word & LOCK_OWNER) != static_cast<std::uint32_t>(thread.number))
            return;
        const std::uint32_t left = (word & LOCK_WAITERS) | LOCK_OWNER_DIED;
        memory().write(address, &left, sizeof left);
        futex_wake(futex_key(address), 1, ANY_BITS);
    };
    std::uint32_t entry = head.next;
    for (unsigned i = 0; i < MOST && (entry & ~1u) != thread.robust_list; ++i) {
        std::uint32_t next;
        if (!memory().read(entry & ~1u, &next, sizeof next)) break;
        if (entry != head.pending) give_back(entry);
        entry = next;
    }
    if (head.pending != 0) give_back(head.pending);
}

// ---- Who waits for whom -------------------------------------------------------------------------

// "the mutex at 0x00021044 that thread 3 has", by how the C library lays out its mutexes.
std::string LinuxKernel::awaited(const LinuxThread& thread) const {
    const auto waiter = std::find_if(waiters_.begin(), waiters_.end(),
                                     [&](const FutexWaiter& w) { return w.thread == &thread; });
    if (waiter == waiters_.end()) {
        for (const auto& module : modules_)
            for (const auto& [server, request] : module->served)
                if (request->thread == &thread && server->wait)
                    return fmt::format("{}, which waits for {}", thread.wait->what,
                                       awaited(*server));
        return thread.wait->what;
    }
    const std::uint32_t address = waiter->address;
    std::uint32_t words[3];
    const bool read = thread.process.memory->read(address, words, sizeof words);
    for (const LinuxThread* const other : threads()) {
        if (&other->process != &thread.process && !thread.process.module) continue;
        if (other->clears == address && other != &thread)
            return fmt::format("the end of thread {}", other->number);
        const auto number = static_cast<std::uint32_t>(other->number);
        if (read && (words[0] == 2 ? words[2] : words[0] & LOCK_OWNER) == number)
            return fmt::format("the mutex at 0x{:08X} that {} has", address,
                               other == &thread ? "it" : fmt::format("thread {}", number));
    }
    return fmt::format("a change of 0x{:08X} (a mutex, a condition variable or the like)", address);
}

// All wait for each other, and nothing from outside can change that.
bool LinuxKernel::is_deadlock() const {
    const std::vector<LinuxThread*> all = threads();
    if (std::all_of(all.begin(), all.end(), [](const auto* t) { return t->process.module; }))
        return false;
    for (const LinuxThread* const thread : all)
        if (!thread->wait || !(thread->wait->inside || is_in_module(*thread))) return false;
    const auto hears = [](const LinuxProcess& process) {
        const auto& actions = process.signals.actions;
        return process.stopped || actions[SIGINT].handled() || actions[SIGQUIT].handled() ||
               actions[SIGTSTP].handled();
    };
    return std::none_of(processes_.begin(), processes_.end(),
                        [&](const auto& process) { return hears(*process); });
}

}  // namespace sim
