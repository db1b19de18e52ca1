#include "sim/linux/scheduler.h"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

constexpr double NORMAL_WEIGHT = 1024, IDLE_WEIGHT = 3, NICE_STEP = 1.25;  // per step of nice

bool in_real_time(const LinuxThread& thread) {
    return thread.share.policy == LinuxScheduler::FIFO || thread.share.policy == LinuxScheduler::RR;
}

double weight_of(const LinuxThread& thread) {
    if (thread.share.policy == LinuxScheduler::IDLE) return IDLE_WEIGHT;
    return NORMAL_WEIGHT / std::pow(NICE_STEP, thread.share.nice);
}

}  // namespace

bool LinuxScheduler::before(const LinuxThread& a, const LinuxThread& b) const {
    if (in_real_time(a) != in_real_time(b)) return in_real_time(a);
    if (in_real_time(a)) {
        if (a.share.priority != b.share.priority) return a.share.priority > b.share.priority;
    } else if (a.share.used_ns != b.share.used_ns) {
        return a.share.used_ns < b.share.used_ns;
    }
    return a.share.turn < b.share.turn;
}

const LinuxThread* LinuxScheduler::first() const {
    const auto first =
        std::min_element(queue_.begin(), queue_.end(),
                         [this](const auto* a, const auto* b) { return before(*a, *b); });
    return first == queue_.end() ? nullptr : *first;
}

void LinuxScheduler::add(LinuxThread& thread, bool woken) {
    if (thread.ready) return;
    if (woken) {  // who has slept for long has not saved up more than this
        const std::uint64_t saved = LATENCY_NS / 2;
        const std::uint64_t least = least_used_ns_ > saved ? least_used_ns_ - saved : 0;
        thread.share.used_ns = std::max(thread.share.used_ns, least);
    }
    thread.share.turn = ++turn_;
    thread.ready = true;
    queue_.push_back(&thread);
}

void LinuxScheduler::remove(LinuxThread& thread) {
    queue_.erase(std::remove(queue_.begin(), queue_.end(), &thread), queue_.end());
    thread.ready = false;
}

LinuxThread& LinuxScheduler::pop(std::uint64_t now_ns) {
    LinuxThread& next = const_cast<LinuxThread&>(*first());
    if (!in_real_time(next)) least_used_ns_ = std::max(least_used_ns_, next.share.used_ns);
    return take(next, now_ns);
}

LinuxThread& LinuxScheduler::take(LinuxThread& thread, std::uint64_t now_ns) {
    remove(thread);
    begin_ns_ = accounted_ns_ = now_ns;
    return thread;
}

void LinuxScheduler::account(LinuxThread& running, std::uint64_t now_ns) {
    const auto ran = static_cast<double>(now_ns - accounted_ns_);
    accounted_ns_ = now_ns;
    if (!in_real_time(running))
        running.share.used_ns +=
            static_cast<std::uint64_t>(std::llround(ran * NORMAL_WEIGHT / weight_of(running)));
}

std::uint64_t LinuxScheduler::end_of_turn_ns(const LinuxThread& running) const {
    if (queue_.empty()) return LinuxWait::NEVER;
    if (in_real_time(running)) {
        const bool shared = std::any_of(queue_.begin(), queue_.end(), [&](const LinuxThread* t) {
            return in_real_time(*t) && t->share.priority == running.share.priority;
        });
        return shared && running.share.policy == RR ? begin_ns_ + ROUND_NS : LinuxWait::NEVER;
    }
    double all = weight_of(running);
    for (const LinuxThread* thread : queue_)
        if (!in_real_time(*thread)) all += weight_of(*thread);
    const auto part = static_cast<std::uint64_t>(
        std::llround(static_cast<double>(LATENCY_NS) * weight_of(running) / all));
    return begin_ns_ + std::max(part, MIN_NS);
}

bool LinuxScheduler::preempts(const LinuxThread& running, std::uint64_t now_ns) const {
    const LinuxThread* const other = first();
    if (!other) return false;
    if (in_real_time(running) || in_real_time(*other)) {
        if (!in_real_time(running)) return true;
        if (!in_real_time(*other)) return false;
        if (other->share.priority != running.share.priority)
            return other->share.priority > running.share.priority;
        return now_ns >= end_of_turn_ns(running);
    }
    return now_ns >= end_of_turn_ns(running) ||
           other->share.used_ns + GRANULARITY_NS < running.share.used_ns;
}

void LinuxScheduler::put_behind(LinuxThread& thread) const {
    thread.share.used_ns = std::max(thread.share.used_ns, least_used_ns_) + MIN_NS;
}

// Only to run again after those that could run now.
void LinuxScheduler::yield(LinuxThread& running) {
    const LinuxThread* const other = first();
    if (other && !in_real_time(running) && !in_real_time(*other))
        running.share.used_ns = std::max(running.share.used_ns, other->share.used_ns);
    add(running, false);
}

}  // namespace sim
