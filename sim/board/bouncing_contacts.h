// bouncing_contacts.h - contacts that close and open by hand, and bounce
//
// A contact that is moved makes or breaks at once and then bounces: it goes back and forth a few
// times, at times drawn from a generator with the given seed.  One that is moved again while it
// bounces begins again.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <random>

#include "sim/pins/agenda.h"

namespace sim {

class BouncingContacts {
public:
    struct Bounce {
        unsigned most;            // times, at least once
        std::uint64_t within_ns;  // 0: it does not
    };

    // `moved` is called after each change.
    BouncingContacts(Agenda& agenda, std::uint64_t seed, std::function<void()> moved)
        : agenda_{agenda}, moved_{std::move(moved)}, random_{seed} {}

    // Bit n is contact n; from agenda.now_ps() on.
    void move(std::uint32_t contacts, bool closed, Bounce bounce);

    std::uint32_t closed() const { return closed_; }  // as they are now

private:
    struct Change {
        unsigned contact;
        bool closed;
    };

    void step();
    std::uint64_t random(std::uint64_t below) { return random_() % below; }

    Agenda& agenda_;
    std::function<void()> moved_;
    std::mt19937_64 random_;
    std::multimap<std::uint64_t, Change> pending_;  // by their times
    PartTimer next_{agenda_, [this] { step(); }};
    std::uint32_t closed_ = 0;
};

}  // namespace sim
