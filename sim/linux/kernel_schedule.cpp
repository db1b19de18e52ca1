// kernel_schedule.cpp - LinuxKernel's threads in time: which runs, which waits, what ends that
#include <algorithm>
#include <csignal>

#include <fmt/format.h>

#include "sim/linux/kernel.h"

namespace sim {

namespace {

constexpr unsigned MOST_REASONS = 8;  // in a message

}  // namespace

std::uint64_t LinuxKernel::now_ns() const { return cpu_.now().value() / 1000; }

std::uint64_t LinuxKernel::later_ns(std::uint64_t span_ns) const {
    return (cpu_.now().value() + 999) / 1000 + std::min(span_ns, LONGEST_NS);
}

std::vector<LinuxThread*> LinuxKernel::threads() const {
    std::vector<LinuxThread*> all;
    for (const auto& process : processes_)
        for (const auto& thread : process->threads) all.push_back(thread.get());
    for (const auto& module : modules_)
        for (const auto& thread : module->process->threads) all.push_back(thread.get());
    return all;
}

// ---- Waiting ------------------------------------------------------------------------------------

LinuxKernel::Result LinuxKernel::wait(LinuxWait wait) {
    if (wait.look)
        if (const Result result = wait.look(wait)) {
            running_->signals.restore_mask();
            return result;
        }
    running_->wait = std::move(wait);
    return std::nullopt;
}

// Ends what it waits for; without a result its registers stay.
void LinuxKernel::resume(LinuxThread& thread, Result result) {
    if (result) thread.r[0] = static_cast<std::uint32_t>(*result);
    thread.wait.reset();
    waiters_.remove_if([&](const FutexWaiter& w) { return w.thread == &thread; });
    if (!thread.process.stopped) scheduler_.add(thread, true);
}

void LinuxKernel::look(LinuxThread& thread) {
    LinuxProcess* const present = process_;
    process_ = &thread.process;
    looks_ = &thread;
    const Result result = thread.wait->look(*thread.wait);
    looks_ = nullptr;
    process_ = present;
    if (!result) return;
    thread.signals.restore_mask();
    resume(thread, result);
}

// What one does may let another go on.
void LinuxKernel::look_at_all() {
    bool changed;
    do {
        changed = std::exchange(changed_, false);
        if (!any_waits()) return;
        const std::uint64_t now = now_ns();
        for (LinuxThread* const thread : threads())
            if (thread->wait && thread->wait->look && (changed || thread->wait->at_ns <= now))
                look(*thread);
        for (LinuxThread* const thread : threads()) {
            if (!thread->wait || !wakes(*thread)) continue;
            if (!thread->wait->uninterrupted)
                interrupt(*thread);
            else if (thread->wait->interrupted)
                thread->wait->interrupted();
        }
    } while (changed_);
}

bool LinuxKernel::any_waits() const {
    const auto all = threads();
    return std::any_of(all.begin(), all.end(), [](const auto* t) { return t->wait.has_value(); });
}

// ---- The processor ------------------------------------------------------------------------------

void LinuxKernel::suspend() {
    LinuxThread& thread = *running_;
    restart_sequence();
    thread.save(cpu_.core());
    running_ = nullptr;
    if (thread.wait || thread.process.stopped) return;
    if (std::exchange(yields_, false))
        scheduler_.yield(thread);
    else
        scheduler_.add(thread, false);
}

// The kernel's is always there.
void LinuxKernel::attach_memory_of(const LinuxThread& thread) {
    const LinuxProcess* const process =
        thread.process.module ? process_below(thread) : &thread.process;
    if (!process || attached_ == process->memory.get()) return;
    if (attached_) attached_->detach();
    attached_ = process->memory.get();
    if (attached_) attached_->attach();
}

void LinuxKernel::run(LinuxThread& thread) {
    running_ = &thread;
    process_ = &thread.process;
    since_ns_ = now_ns();
    attach_memory_of(thread);
    thread.load(cpu_.core());
    helpers_.set_tls(thread.tls);
}

void LinuxKernel::account() {
    const std::uint64_t now = now_ns();
    if (!running_) return;
    scheduler_.account(*running_, now);
    running_->used_ns += now - since_ns_;
    running_->process.used_ns += now - since_ns_;
    since_ns_ = now;
}

void LinuxKernel::go_on() {
    account();
    while (!over_) {
        led_.expire();
        if (host_network_.next_ns() <= now_ns()) changed_ |= host_network_.look(now_ns(), false);
        changed_ |= terminal_.arrive();
        receive_from_outside();
        expire_timers();
        if (running_ && running_->wait) suspend();
        find_lockup();
        take_interrupts();
        look_at_all();
        if (running_ && (yields_ || scheduler_.preempts(*running_, now_ns()))) suspend();
        if (!running_ && scheduler_.empty()) {
            stand_still();
            continue;
        }
        if (!running_) run(next_thread());
        deliver();
        if (running_ && !running_->wait) break;
    }
    const std::uint64_t next =
        over_ ? LinuxWait::NEVER
              : std::min({next_event_ns(), led_.next_ns(), host_network_.next_ns()});
    cpu_.set_alarm(next == LinuxWait::NEVER ? sc_core::sc_max_time()
                                            : sc_core::sc_time::from_value(next * 1000));
}

// A module's thread comes at once after the program's that has called it, and that one after it.
LinuxThread& LinuxKernel::next_thread() {
    LinuxThread* const next = std::exchange(next_, nullptr);
    if (next && next->ready && !scheduler_.preempts(*next, now_ns()))
        return scheduler_.take(*next, now_ns());
    return scheduler_.pop(now_ns());
}

void LinuxKernel::alarm(ArmCore&) { go_on(); }

std::uint64_t LinuxKernel::next_event_ns() const {
    std::uint64_t next = running_ ? scheduler_.end_of_turn_ns(*running_) : LinuxWait::NEVER;
    for (const LinuxThread* const thread : threads())
        if (thread->wait) next = std::min(next, thread->wait->at_ns);
    next = std::min({next, next_timer_ns(), lockup_ns()});
    if (const auto typed = terminal_.next_arrival())
        next = std::min<std::uint64_t>(next, (typed->value() + 999) / 1000);
    return next;
}

bool LinuxKernel::may_interrupt() const {
    return threads().size() > 1 || next_event_ns() != LinuxWait::NEVER;
}

// No thread can run: lets time pass until something happens.
void LinuxKernel::stand_still() {
    cpu_.pause(sc_core::SC_ZERO_TIME);  // what others do until now comes first
    const std::uint64_t now = now_ns();
    if (host_network_.is_used()) changed_ |= host_network_.look(now, true);
    const std::uint64_t next =
        std::min({next_event_ns(), led_.next_ns(), host_network_.next_ns(), now + LONGEST_NS});
    if (next <= now) return;
    if (next_event_ns() == LinuxWait::NEVER && is_deadlock()) {
        cpu_.show_end(SIGABRT);
        over_ = true;
        return cpu_.end(
            fmt::format("deadlock: no thread can ever go on {}: {}", cpu_.where(), waiting_list()));
    }
    cpu_.pause(woken_, sc_core::sc_time::from_value((next - now) * 1000));
}

std::string LinuxKernel::waiting() const { return running_ ? "" : waiting_list(); }

std::string LinuxKernel::waiting_list() const {
    std::string all;
    std::vector<LinuxThread*> list = threads();
    list.erase(std::remove_if(list.begin(), list.end(),
                              [](const auto* t) { return t->wait && t->wait->idle; }),
               list.end());
    const auto reason = [this](const LinuxThread& thread) -> std::string {
        return thread.process.stopped ? "SIGCONT, because it is stopped"
               : thread.wait          ? awaited(thread)
                                      : "its turn";
    };
    if (list.size() == 1) return reason(*list[0]);
    unsigned reasons = 0;
    for (std::size_t first = 0, after; first < list.size(); first = after) {
        const std::string why = reason(*list[first]);
        after = first + 1;
        while (after < list.size() && reason(*list[after]) == why) ++after;
        if (first > 0) all += "; ";
        if (++reasons > MOST_REASONS)
            return all + fmt::format("and {} threads more", list.size() - first);
        all += after - first == 1 ? fmt::format("thread {}: {}", list[first]->number, why)
                                  : fmt::format("threads {} to {}: {}", list[first]->number,
                                                list[after - 1]->number, why);
    }
    return all;
}

}  // namespace sim
