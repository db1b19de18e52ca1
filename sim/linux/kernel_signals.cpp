// kernel_signals.cpp - LinuxKernel's signals: who gets one, what it does, the calls for them
#include <cerrno>
#include <csignal>

#include <fmt/format.h>

#include "sim/linux/alignment.h"
#include "sim/linux/arm_abi.h"
#include "sim/linux/kernel.h"

namespace sim {

namespace {

constexpr std::uint64_t STOP_SIGNALS = LinuxSignals::bit(SIGSTOP) | LinuxSignals::bit(SIGTSTP) |
                                       LinuxSignals::bit(SIGTTIN) | LinuxSignals::bit(SIGTTOU);
constexpr std::uint64_t NEVER_BLOCKED = LinuxSignals::bit(SIGKILL) | LinuxSignals::bit(SIGSTOP);
constexpr const char* BY_ITSELF = "sent by itself";

}  // namespace

// ---- Sending ------------------------------------------------------------------------------------

bool LinuxKernel::send(LinuxThread& thread, const LinuxSignal& signal) {
    LinuxProcess& process = thread.process;
    const std::uint64_t bit = LinuxSignals::bit(signal.number);
    if (signal.number == SIGCONT || signal.number == SIGKILL) {
        process.pending.remove(STOP_SIGNALS);
        for (const auto& one : process.threads) one->signals.pending.remove(STOP_SIGNALS);
        const bool stopped = std::exchange(process.stopped, false);
        for (const auto& one : process.threads)
            if (stopped && !one->wait) scheduler_.add(*one, true);
    }
    changed_ = true;
    const bool blocked = thread.signals.blocked & bit;
    if (!blocked && process.signals.ignores(signal.number)) return true;
    return thread.signals.pending.add(signal);
}

bool LinuxKernel::send(LinuxProcess& process, const LinuxSignal& signal) {
    for (const auto& thread : process.threads)
        if (!(thread->signals.blocked & LinuxSignals::bit(signal.number)))
            return send(*thread, signal);
    changed_ = true;
    return process.pending.add(signal);
}

void LinuxKernel::typed(unsigned number) {
    const char* const key = number == SIGINT ? "^C" : number == SIGQUIT ? "^\\" : "^Z";
    for (const auto& process : processes_)
        if (process->group == LinuxProcess::FIRST)  // in the foreground of the terminal
            send(
                *process,
                {number, arm_signal_code::KERNEL, {}, fmt::format("{} was typed,", key), {}, true});
}

void LinuxKernel::signal_from_outside(unsigned number, int process) {
    from_outside_.emplace_back(number, process);
    if (over_) return receive_from_outside();
    feel();
}

void LinuxKernel::receive_from_outside() {
    for (const auto& [number, to] : std::exchange(from_outside_, {})) {
        LinuxProcess* const process = process_of(to);
        if (over_ || !process || process->status)
            outside_.log(
                fmt::format("{} was sent to process {}, which {}, {}", LinuxSignals::name(number),
                            to, over_ || process ? "has ended" : "is not there", cpu_.where()));
        else
            send(*process,
                 {number, arm_signal_code::USER, {}, "it was sent from outside,", {}, true});
    }
}

std::optional<LinuxSignal> LinuxKernel::take_signal(LinuxThread& thread, std::uint64_t blocked) {
    auto signal = thread.signals.pending.dequeue(blocked);
    if (!signal) signal = thread.process.pending.dequeue(blocked);
    if (signal) go_on_with_timer(thread.process, *signal);
    return signal;
}

std::uint64_t LinuxKernel::wakes(const LinuxThread& thread) const {
    return (thread.signals.pending.set() | thread.process.pending.set()) & ~thread.signals.blocked;
}

// A thread that waits has a signal: it acts on it, unless that only stops it.
void LinuxKernel::interrupt(LinuxThread& thread) {
    if (thread.process.stopped) return;
    LinuxWait& wait = *thread.wait;
    thread.restarts = wait.restarts && wait.done == 0;
    if (wait.interrupted) wait.interrupted();
    resume(thread, thread.restarts ? Result{} : wait.done > 0 ? wait.done : -EINTR);
}

// ---- What they do -------------------------------------------------------------------------------

void LinuxKernel::deliver() {
    LinuxThread& thread = *running_;
    ArmCore& core = cpu_.core();
    const auto begin_anew = [&] {
        core.set_reg(15, core.reg(15) - (core.cpsr() & arm_cpsr::T ? 2 : 4));
        thread.restarts = false;
    };
    while (running_ == &thread && !over_) {
        const auto signal = take_signal(thread, thread.signals.blocked);
        if (!signal) break;
        LinuxSignals& signals = process_->signals;
        LinuxSignals::Action& action = signals.actions[signal->number];
        if (signals.ignores(signal->number)) continue;
        if (action.handled()) {
            if (thread.restarts && (action.flags & arm_signal::RESTARTS)) begin_anew();
            if (std::exchange(thread.restarts, false))
                core.set_reg(0, static_cast<std::uint32_t>(-EINTR));
            restart_sequence();
            if (!thread.signals.enter(core, memory(), action, *signal))
                die({SIGSEGV, 0, {}, "no room on the stack for the handler of a signal"});
        } else if (LinuxSignals::stops_by_default(signal->number)) {
            outside_.log(fmt::format(
                "the program was stopped by {}: {} and there is no shell to let it go on, {}",
                LinuxSignals::name(signal->number), signal->why, cpu_.where()));
            if (thread.restarts) begin_anew();
            process_->stopped = true;
            for (const auto& one : process_->threads) scheduler_.remove(*one);
            suspend();
        } else {
            die(*signal);
        }
    }
    if (running_ != &thread || over_) return;
    if (thread.restarts) begin_anew();
    thread.signals.restore_mask();
}

void LinuxKernel::fault(const LinuxSignal& signal) {
    if (process_->module) return stop_by_fault(signal.number, signal.fields[0], signal.why);
    LinuxSignals::Action& action = process_->signals.actions[signal.number];
    const bool blocked = running_->signals.blocked & LinuxSignals::bit(signal.number);
    if (action.handled() && !blocked &&
        running_->signals.enter(cpu_.core(), memory(), action, signal))
        return;
    die(signal);
}

// What a person sends may end a program: that is no fault.
void LinuxKernel::die(const LinuxSignal& signal) {
    if (process_->number != processes_.front()->number)
        return end_process(*process_, signal.number);
    const std::string text =
        fmt::format("the program was ended by {}: {} {}", LinuxSignals::name(signal.number),
                    signal.why, cpu_.where());
    cpu_.show_end(signal.number);
    over_ = true;
    if (!signal.by_hand) return cpu_.end(text);
    constexpr int OF_A_SHELL = 128;
    exit_code_ = OF_A_SHELL + static_cast<int>(signal.number);
    outside_.log(text);
    cpu_.end();
}

void LinuxKernel::unaligned(ArmCore& core, const ArmFault& abort, const std::string& what) {
    const bool thumb = core.cpsr() & arm_cpsr::T;
    const std::uint32_t pc = core.pc();
    std::uint16_t halves[2]{};
    memory().read(pc, &halves[0], 2);
    const bool wide = !thumb || halves[0] >= 0xE800;
    if (wide) memory().read(pc + 2, &halves[1], 2);
    const std::uint32_t word = !thumb ? halves[0] | std::uint32_t{halves[1]} << 16
                               : wide ? std::uint32_t{halves[0]} << 16 | halves[1]
                                      : halves[0];
    if (!kernel_does_unaligned(word, thumb))
        return fault({SIGBUS, arm_signal_code::MISALIGNED, {abort.address}, what});
    if (unaligned_.insert(pc).second)
        outside_.log(fmt::format("{}; Linux does it byte by byte, {}", what, cpu_.where()));
    if (core.run_by_bytes() == ArmStop::DATA_ABORT)
        exception(core, ArmException::DATA_ABORT, core.fault(), "data abort");
}

// ---- The calls ----------------------------------------------------------------------------------

LinuxKernel::Result LinuxKernel::sys_sigaction(const Arguments& a) {
    const std::uint32_t number = a[0];
    if (number < 1 || number > LinuxSignals::COUNT || a[3] != 8) return -EINVAL;
    if (a[1] != 0 && (number == SIGKILL || number == SIGSTOP)) return -EINVAL;
    LinuxSignals::Action& action = process_->signals.actions[number];
    struct {
        std::uint32_t handler, flags, restorer, mask[2];
    } words;
    static_assert(sizeof words == 20);
    const auto was = action;
    if (a[1] != 0) {
        if (!memory().read(a[1], &words, sizeof words)) return -EFAULT;
        action = {words.handler, words.flags, words.restorer,
                  (std::uint64_t{words.mask[1]} << 32 | words.mask[0]) & ~NEVER_BLOCKED};
        if (process_->signals.ignores(number)) {
            process_->pending.remove(LinuxSignals::bit(number));
            for (const auto& thread : process_->threads)
                thread->signals.pending.remove(LinuxSignals::bit(number));
        }
    }
    if (a[2] != 0) {
        words = {
            was.handler,
            was.flags,
            was.restorer,
            {static_cast<std::uint32_t>(was.mask), static_cast<std::uint32_t>(was.mask >> 32)}};
        if (!memory().write(a[2], &words, sizeof words)) return -EFAULT;
    }
    return 0;
}

LinuxKernel::Result LinuxKernel::sys_sigprocmask(const Arguments& a) {
    std::uint64_t& blocked = running_->signals.blocked;
    if (a[3] != sizeof blocked) return -EINVAL;
    const std::uint64_t was = blocked;
    if (a[1] != 0) {
        std::uint64_t set;
        if (!memory().read(a[1], &set, sizeof set)) return -EFAULT;
        set &= ~NEVER_BLOCKED;
        switch (a[0]) {
            case SIG_BLOCK: blocked |= set; break;
            case SIG_UNBLOCK: blocked &= ~set; break;
            case SIG_SETMASK: blocked = set; break;
            default: return -EINVAL;
        }
    }
    return a[2] == 0 || memory().write(a[2], &was, sizeof was) ? 0 : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_sigpending(const Arguments& a) {
    const std::uint64_t set =
        (running_->signals.pending.set() | process_->pending.set()) & running_->signals.blocked;
    if (a[1] > sizeof set) return -EINVAL;
    return memory().write(a[0], &set, a[1]) ? 0 : -EFAULT;
}

// For the time of a call that waits; without an address it stays.
std::int64_t LinuxKernel::mask_meanwhile(std::uint32_t address, std::uint32_t bytes) {
    std::uint64_t set;
    if (address == 0) return 0;
    if (bytes != sizeof set) return -EINVAL;
    if (!memory().read(address, &set, sizeof set)) return -EFAULT;
    running_->signals.waits_with = std::exchange(running_->signals.blocked, set & ~NEVER_BLOCKED);
    return 0;
}

LinuxKernel::Result LinuxKernel::sys_sigsuspend(const Arguments& a) {
    if (a[0] == 0) return -EFAULT;
    if (const std::int64_t error = mask_meanwhile(a[0], a[1])) return error;
    return sys_pause(a);
}

LinuxKernel::Result LinuxKernel::sys_pause(const Arguments&) {
    LinuxWait wait;
    wait.what = "a signal";
    return this->wait(std::move(wait));
}

LinuxKernel::Result LinuxKernel::sigtimedwait(const Arguments& a, Span kind) {
    std::uint64_t set;
    if (a[3] != sizeof set) return -EINVAL;
    if (!memory().read(a[0], &set, sizeof set)) return -EFAULT;
    const std::int64_t span = span_at(a[2], kind);
    if (span < 0) return span;
    LinuxWait wait;
    wait.what = "a signal";
    if (a[2] != 0) wait.at_ns = later_ns(static_cast<std::uint64_t>(span));
    wait.look = [this, set, to = a[1], &thread = *running_](LinuxWait& w) -> Result {
        const auto signal = take_signal(thread, ~set);
        if (!signal) return now_ns() >= w.at_ns ? Result{-EAGAIN} : std::nullopt;
        std::uint32_t info[32] = {signal->number, 0, static_cast<std::uint32_t>(signal->code)};
        std::copy(signal->fields.begin(), signal->fields.end(), info + 3);
        if (to != 0 && !memory().write(to, info, sizeof info)) return -EFAULT;
        return signal->number;
    };
    return this->wait(std::move(wait));
}

LinuxKernel::Result LinuxKernel::sys_sigtimedwait(const Arguments& a) {
    return sigtimedwait(a, Span::TIMESPEC);
}
LinuxKernel::Result LinuxKernel::sys_sigtimedwait_time64(const Arguments& a) {
    return sigtimedwait(a, Span::TIMESPEC64);
}

LinuxKernel::Result LinuxKernel::sys_sigaltstack(const Arguments& a) {
    constexpr std::uint32_t OFF = 2;
    ThreadSignals& signals = running_->signals;
    const std::uint32_t was[3] = {signals.stack, signals.stack_size ? 0 : OFF, signals.stack_size};
    std::uint32_t words[3];
    if (a[0] != 0) {
        if (!memory().read(a[0], words, sizeof words)) return -EFAULT;
        signals.stack = words[0];
        signals.stack_size = words[1] & OFF ? 0 : words[2];
    }
    return a[1] == 0 || memory().write(a[1], was, sizeof was) ? 0 : -EFAULT;
}

LinuxKernel::Result LinuxKernel::sys_sigreturn(const Arguments&) {
    if (!running_->signals.leave(cpu_.core(), memory(), false))
        fault({SIGSEGV, arm_signal_code::KERNEL, {}, "no signal to return from"});
    return std::nullopt;
}

LinuxKernel::Result LinuxKernel::sys_rt_sigreturn(const Arguments&) {
    if (!running_->signals.leave(cpu_.core(), memory(), true))
        fault({SIGSEGV, arm_signal_code::KERNEL, {}, "no signal to return from"});
    return std::nullopt;
}

// To a process, or for 0, -1 and a group to all of them: they are of one group.
LinuxKernel::Result LinuxKernel::sys_kill(const Arguments& a) {
    const auto to = static_cast<std::int32_t>(a[0]);
    if (a[1] > LinuxSignals::COUNT) return -EINVAL;
    const LinuxSignal signal{
        a[1], arm_signal_code::USER, {static_cast<std::uint32_t>(process_->number)}, BY_ITSELF};
    std::int64_t result = -ESRCH;
    for (const auto& process : processes_) {
        const bool meant = to > 0     ? process->number == to
                           : to == -1 ? process.get() != process_ || processes_.size() == 1
                                      : process->group == (to == 0 ? process_->group : -to);
        if (!meant) continue;
        result = 0;
        if (a[1] != 0) send(*process, signal);
    }
    return result;
}

LinuxKernel::Result LinuxKernel::sys_tkill(const Arguments& a) {
    if (a[1] > LinuxSignals::COUNT || static_cast<std::int32_t>(a[0]) <= 0) return -EINVAL;
    for (LinuxThread* const thread : threads()) {
        if (thread->number != static_cast<int>(a[0])) continue;
        const LinuxSignal signal{a[1],
                                 arm_signal_code::TKILL,
                                 {static_cast<std::uint32_t>(process_->number)},
                                 BY_ITSELF};
        return a[1] == 0 || send(*thread, signal) ? 0 : -EAGAIN;
    }
    return -ESRCH;
}

LinuxKernel::Result LinuxKernel::sys_tgkill(const Arguments& a) {
    for (const LinuxThread* const thread : threads())
        if (thread->number == static_cast<int>(a[1]) &&
            thread->process.number != static_cast<int>(a[0]))
            return -ESRCH;
    return sys_tkill({a[1], a[2]});
}

// With a value of the sender's, struct siginfo.
LinuxKernel::Result LinuxKernel::sys_sigqueueinfo(const Arguments& a) {
    std::uint32_t info[6];
    if (!memory().read(a[2], info, sizeof info)) return -EFAULT;
    if (a[1] > LinuxSignals::COUNT) return -EINVAL;
    const LinuxSignal signal{
        a[1], static_cast<std::int32_t>(info[2]), {info[3], info[4], info[5]}, BY_ITSELF};
    if (signal.code >= 0) return -EPERM;
    for (const auto& process : processes_)
        if (process->number == static_cast<int>(a[0]))
            return a[1] == 0 || send(*process, signal) ? 0 : -EAGAIN;
    return -ESRCH;
}

}  // namespace sim
