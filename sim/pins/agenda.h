// agenda.h - what the board will do, in the order of the time at the pins
//
// A part that acts by its own time - a contact that bounces, a device that makes a clock - enters
// what it does next, and when.  So does a hand at the board.  Whoever plays the chip runs it up to
// next_ps(), calls run_to(), and goes on: an entry so finds the chip at its time, and what it moves
// counts from there on, however far the chip runs at once.
//
// Entries of the same time are carried out in the order in which they were entered.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>

namespace sim {

class Agenda {
public:
    static constexpr std::uint64_t NEVER = ~std::uint64_t{0};
    using Action = std::function<void()>;
    using Entry = std::multimap<std::uint64_t, Action>::iterator;

    Agenda() = default;
    Agenda(const Agenda&) = delete;
    Agenda& operator=(const Agenda&) = delete;

    // A time that has passed is the next opportunity.  The entry is valid until it is carried out.
    Entry at(std::uint64_t time_ps, Action action) {
        const Entry entry = entries_.emplace(time_ps, std::move(action));
        look();
        return entry;
    }
    void cancel(Entry entry) {
        entries_.erase(entry);
        look();
    }

    std::uint64_t next_ps() const { return next_ps_; }  // NEVER: there is none
    // The time at the pins: that of the entry which is carried out, of the output that has moved.
    std::uint64_t now_ps() const { return now_ps_; }

    // Carries out all entries up to and with this time, also those that they make.
    void run_to(std::uint64_t time_ps) {
        while (next_ps_ <= time_ps) {
            const auto entry = entries_.extract(entries_.begin());
            pass_to(entry.key());
            look();
            entry.mapped()();
        }
        pass_to(time_ps);
    }
    // It is at least as late as this.
    void pass_to(std::uint64_t time_ps) { now_ps_ = std::max(now_ps_, time_ps); }

    // `notify` is called with next_ps() whenever that is another.
    void on_next(std::function<void(std::uint64_t)> notify) {
        notify_ = std::move(notify);
        notify_(next_ps_);
    }

private:
    void look() {
        const std::uint64_t next = entries_.empty() ? NEVER : entries_.begin()->first;
        if (std::exchange(next_ps_, next) != next) notify_(next);
    }

    std::multimap<std::uint64_t, Action> entries_;
    std::uint64_t next_ps_ = NEVER, now_ps_ = 0;
    std::function<void(std::uint64_t)> notify_ = [](std::uint64_t) {};
};

// The timer of a part: an entry that is made again and again, one at a time.
class PartTimer {
public:
    PartTimer(Agenda& agenda, Agenda::Action action)
        : agenda_{agenda}, action_{std::move(action)} {}
    ~PartTimer() { cancel(); }
    PartTimer(const PartTimer&) = delete;
    PartTimer& operator=(const PartTimer&) = delete;

    // In place of the time set before.
    void set(std::uint64_t time_ps) {
        cancel();
        entry_ = agenda_.at(time_ps, [this] {
            is_set_ = false;
            action_();
        });
        is_set_ = true;
    }
    void set_in(std::uint64_t ps) { set(agenda_.now_ps() + ps); }
    void cancel() {
        if (std::exchange(is_set_, false)) agenda_.cancel(entry_);
    }
    bool is_set() const { return is_set_; }

private:
    Agenda& agenda_;
    const Agenda::Action action_;
    Agenda::Entry entry_;
    bool is_set_ = false;
};

}  // namespace sim
