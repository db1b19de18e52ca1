// kernel_threads.cpp - LinuxKernel's calls that make and end threads, and say how they share the
// processor
#include <algorithm>
#include <cerrno>
#include <csignal>

#include <fmt/format.h>

#include "sim/linux/arm_abi.h"
#include "sim/linux/kernel.h"

namespace sim {

namespace {

constexpr std::uint32_t BOTH_PROCESSORS = 3;
constexpr std::size_t MOST_THREADS = 1024;
constexpr std::uint32_t RESET_ON_FORK = 0x40000000;

std::uint32_t bits_of(int value) { return static_cast<std::uint32_t>(value); }

}  // namespace

// ---- Begin and end ------------------------------------------------------------------------------

LinuxKernel::Result LinuxKernel::clone(const Clone& how) {
    using namespace arm_clone;
    constexpr std::uint64_t TOGETHER = VM | SIGHAND | THREAD;
    if (((how.flags & THREAD) && (how.flags & TOGETHER) != TOGETHER) ||
        ((how.flags & SIGHAND) && !(how.flags & VM)))
        return -EINVAL;
    if (how.flags & NEW_NAMESPACES) {
        not_emulated("clone with a new namespace");
        return -EINVAL;
    }
    if (threads().size() >= MOST_THREADS) return -EAGAIN;
    const auto word = bits_of(next_number_);
    LinuxProcess& process = *process_;
    if ((how.flags & PARENT_SETTID) && !memory().write(how.parent_word, &word, sizeof word))
        return -EFAULT;
    if (!(how.flags & THREAD)) return fork(how);
    const int number = next_number_++;
    process.threads.push_back(std::make_unique<LinuxThread>(number, process));
    begin_thread(*process.threads.back(), how);
    return number;
}

// As the running one, but for what is asked.
void LinuxKernel::begin_thread(LinuxThread& child, const Clone& how) {
    using namespace arm_clone;
    const auto word = bits_of(child.number);
    child.save(cpu_.core());
    child.r[0] = 0;
    if (how.stack != 0) child.r[13] = how.stack;
    child.tls = how.flags & SETTLS ? how.tls : running_->tls;
    child.signals.blocked = running_->signals.blocked;
    child.name = running_->name;
    child.affinity = running_->affinity;
    child.share = running_->share;
    scheduler_.put_behind(child);
    if (how.flags & CHILD_CLEARTID) child.clears = how.child_word;
    if (how.flags & CHILD_SETTID) child.process.memory->write(how.child_word, &word, sizeof word);
    scheduler_.add(child, false);
}

LinuxKernel::Result LinuxKernel::sys_clone(const Arguments& a) {
    return clone({a[0], a[1], a[2], a[3], a[4]});
}

LinuxKernel::Result LinuxKernel::sys_clone3(const Arguments& a) {
    constexpr std::uint32_t LEAST = 64, MOST = 4096;
    struct {
        std::uint64_t flags, pidfd, child_word, parent_word, exit_signal, stack, stack_bytes, tls;
    } all;
    static_assert(sizeof all == LEAST);
    if (a[1] < LEAST || a[1] > MOST) return -EINVAL;
    if (!memory().read(a[0], &all, sizeof all)) return -EFAULT;
    const auto low = [](std::uint64_t value) { return static_cast<std::uint32_t>(value); };
    return clone({all.flags | all.exit_signal, low(all.stack + all.stack_bytes),
                  low(all.parent_word), low(all.tls), low(all.child_word)});
}

// Its registers and its place among the threads are no more.
void LinuxKernel::end_thread(LinuxThread& thread) {
    LinuxProcess& process = thread.process;
    LinuxProcess* const present = std::exchange(process_, &process);
    give_back_locks(thread);
    forget_requests_of(thread);
    if (thread.clears != 0) {
        constexpr std::uint32_t NOBODY = 0;
        memory().write(thread.clears, &NOBODY, sizeof NOBODY);
        futex_wake(futex_key(thread.clears), 1, ~0u);
    }
    process_ = present;
    scheduler_.remove(thread);
    waiters_.remove_if([&](const FutexWaiter& w) { return w.thread == &thread; });
    if (running_ == &thread) running_ = nullptr;
    process.threads.erase(std::find_if(process.threads.begin(), process.threads.end(),
                                       [&](const auto& one) { return one.get() == &thread; }));
}

LinuxKernel::Result LinuxKernel::sys_exit(const Arguments& a) {
    if (process_->threads.size() == 1) return sys_exit_group(a);
    end_thread(*running_);
    return std::nullopt;
}

LinuxKernel::Result LinuxKernel::sys_set_tls(const Arguments& a) {
    running_->tls = a[0];
    helpers_.set_tls(a[0]);
    return 0;
}

LinuxKernel::Result LinuxKernel::sys_set_tid_address(const Arguments& a) {
    running_->clears = a[0];
    return running_->number;
}

LinuxKernel::Result LinuxKernel::sys_gettid(const Arguments&) { return running_->number; }

// ---- Restartable sequences ----------------------------------------------------------------------

LinuxKernel::Result LinuxKernel::sys_rseq(const Arguments& a) {
    constexpr std::uint32_t UNREGISTER = 1, BYTES = 32, CORE[2] = {0, 0}, NONE[2] = {0, ~0u};
    std::uint32_t& area = running_->sequences;
    if (a[2] & UNREGISTER) {
        if (area == 0 || area != a[0]) return -EINVAL;
        area = 0;
        return memory().write(a[0], NONE, sizeof NONE) ? 0 : -EFAULT;
    }
    if (a[2] != 0 || a[0] % BYTES != 0 || a[1] != BYTES) return -EINVAL;
    if (area != 0) return area == a[0] ? -EBUSY : -EINVAL;
    if (!memory().write(a[0], CORE, sizeof CORE)) return -EFAULT;
    area = a[0];
    return 0;
}

// One in which the running thread is interrupted begins again, where it says.
void LinuxKernel::restart_sequence() {
    constexpr std::uint32_t SEQUENCE = 8;
    struct {
        std::uint32_t version, flags;
        std::uint64_t start, bytes, abort;
    } sequence;
    std::uint32_t at;
    ArmCore& core = cpu_.core();
    const AddressSpace& space = *running_->process.memory;
    if (running_->sequences == 0 || !space.read(running_->sequences + SEQUENCE, &at, sizeof at) ||
        at == 0 || !space.read(at, &sequence, sizeof sequence))
        return;
    constexpr std::uint64_t DONE = 0;
    running_->process.memory->write(running_->sequences + SEQUENCE, &DONE, sizeof DONE);
    if (core.pc() - static_cast<std::uint32_t>(sequence.start) >= sequence.bytes) return;
    core.set_reg(15, static_cast<std::uint32_t>(sequence.abort) & ~1u);
}

// ---- Sharing the processor ----------------------------------------------------------------------

LinuxThread* LinuxKernel::thread_of(std::uint32_t number) const {
    if (number == 0) return running_;
    for (LinuxThread* const thread : threads())
        if (bits_of(thread->number) == number) return thread;
    return nullptr;
}

LinuxKernel::Result LinuxKernel::sys_sched_yield(const Arguments&) {
    yields_ = true;
    return 0;
}

LinuxKernel::Result LinuxKernel::sys_sched_getaffinity(const Arguments& a) {
    const LinuxThread* const thread = thread_of(a[0]);
    if (!thread) return -ESRCH;
    if (a[1] < sizeof thread->affinity || a[1] % sizeof thread->affinity != 0) return -EINVAL;
    return memory().write(a[2], &thread->affinity, sizeof thread->affinity)
               ? int{sizeof thread->affinity}
               : -EFAULT;
}

// As on the board there are two; but one alone executes all threads.
LinuxKernel::Result LinuxKernel::sys_sched_setaffinity(const Arguments& a) {
    LinuxThread* const thread = thread_of(a[0]);
    std::uint32_t mask = 0;
    if (!thread) return -ESRCH;
    if (!memory().read(a[2], &mask, std::min<std::uint32_t>(a[1], sizeof mask))) return -EFAULT;
    if ((mask & BOTH_PROCESSORS) == 0) return -EINVAL;
    thread->affinity = mask & BOTH_PROCESSORS;
    const std::uint32_t core = thread->affinity & 1 ? 0 : 1, both[2] = {core, core};
    if (thread->sequences != 0) thread->process.memory->write(thread->sequences, both, sizeof both);
    return 0;
}

LinuxKernel::Result LinuxKernel::sys_getcpu(const Arguments& a) {
    const std::uint32_t core = running_->affinity & 1 ? 0 : 1, node = 0;
    const bool given = (a[0] == 0 || memory().write(a[0], &core, sizeof core)) &&
                       (a[1] == 0 || memory().write(a[1], &node, sizeof node));
    return given ? 0 : -EFAULT;
}

std::int64_t LinuxKernel::set_policy(LinuxThread& thread, int policy, int priority) {
    const bool in_real_time = policy == LinuxScheduler::FIFO || policy == LinuxScheduler::RR;
    const bool known = in_real_time || policy == LinuxScheduler::OTHER ||
                       policy == LinuxScheduler::BATCH || policy == LinuxScheduler::IDLE;
    if (!known || (in_real_time ? priority < 1 || priority > 99 : priority != 0)) return -EINVAL;
    const bool was_ready = thread.ready;
    scheduler_.remove(thread);
    thread.share.policy = policy;
    thread.share.priority = priority;
    if (was_ready) scheduler_.add(thread, false);
    return 0;
}

LinuxKernel::Result LinuxKernel::sys_sched_setscheduler(const Arguments& a) {
    std::int32_t priority;
    LinuxThread* const thread = thread_of(a[0]);
    if (static_cast<std::int32_t>(a[0]) < 0) return -EINVAL;
    if (!memory().read(a[2], &priority, sizeof priority)) return -EFAULT;
    if (!thread) return -ESRCH;
    return set_policy(*thread, static_cast<int>(a[1] & ~RESET_ON_FORK), priority);
}

LinuxKernel::Result LinuxKernel::sys_sched_getscheduler(const Arguments& a) {
    const LinuxThread* const thread = thread_of(a[0]);
    return thread ? thread->share.policy : -ESRCH;
}

LinuxKernel::Result LinuxKernel::sys_sched_setparam(const Arguments& a) {
    std::int32_t priority;
    LinuxThread* const thread = thread_of(a[0]);
    if (!memory().read(a[1], &priority, sizeof priority)) return -EFAULT;
    return thread ? set_policy(*thread, thread->share.policy, priority) : -ESRCH;
}

LinuxKernel::Result LinuxKernel::sys_sched_getparam(const Arguments& a) {
    const LinuxThread* const thread = thread_of(a[0]);
    if (!thread) return -ESRCH;
    return memory().write(a[1], &thread->share.priority, sizeof thread->share.priority) ? 0
                                                                                        : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_sched_get_priority_max(const Arguments& a) {
    if (a[0] == LinuxScheduler::FIFO || a[0] == LinuxScheduler::RR) return 99;
    return a[0] <= 6 && a[0] != 4 ? 0 : -EINVAL;
}

LinuxKernel::Result LinuxKernel::sys_sched_get_priority_min(const Arguments& a) {
    const Result most = sys_sched_get_priority_max(a);
    return *most > 0 ? 1 : *most;
}

LinuxKernel::Result LinuxKernel::sys_sched_rr_get_interval(const Arguments& a) {
    const LinuxThread* const thread = thread_of(a[0]);
    if (!thread) return -ESRCH;
    const int policy = thread->share.policy;
    return give_time(a[1],
                     policy == LinuxScheduler::FIFO ? 0
                     : policy == LinuxScheduler::RR ? LinuxScheduler::ROUND_NS
                                                    : LinuxScheduler::LATENCY_NS,
                     false);
}

LinuxKernel::Result LinuxKernel::sys_nice(const Arguments& a) {
    int& nice = running_->share.nice;
    const auto step = std::clamp(static_cast<std::int32_t>(a[0]), -40, 40);
    nice = std::clamp(nice + step, -20, 19);
    return 0;
}

// PRIO_PROCESS is a thread; the C library turns 20 - nice back.
LinuxKernel::Result LinuxKernel::sys_getpriority(const Arguments& a) {
    const LinuxThread* const thread = a[0] == 0 ? thread_of(a[1]) : running_;
    return thread ? 20 - thread->share.nice : -ESRCH;
}

LinuxKernel::Result LinuxKernel::sys_setpriority(const Arguments& a) {
    LinuxThread* const thread = a[0] == 0 ? thread_of(a[1]) : running_;
    if (!thread) return -ESRCH;
    thread->share.nice = std::clamp(static_cast<std::int32_t>(a[2]), -20, 19);
    return 0;
}

// A thread's name; of the rest what does nothing here.
LinuxKernel::Result LinuxKernel::sys_prctl(const Arguments& a) {
    constexpr std::uint32_t SET_NAME = 15, GET_NAME = 16, SET_TIMERSLACK = 29, SET_DUMPABLE = 4,
                            SET_DEATH_SIGNAL = 1, NAME = 16;
    char name[NAME] = {};
    switch (a[0]) {
        case SET_NAME: {
            const auto text = memory().string(a[1]);
            if (!text) return -EFAULT;
            running_->name = text->substr(0, NAME - 1);
            return 0;
        }
        case GET_NAME:
            std::copy(running_->name.begin(), running_->name.end(), name);
            return memory().write(a[1], name, sizeof name) ? 0 : -EFAULT;
        case SET_TIMERSLACK:
        case SET_DUMPABLE:
        case SET_DEATH_SIGNAL: return 0;
        default: return -EINVAL;
    }
}

}  // namespace sim
