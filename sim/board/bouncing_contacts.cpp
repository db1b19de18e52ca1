#include "sim/board/bouncing_contacts.h"

#include <algorithm>
#include <set>

namespace sim {

void BouncingContacts::move(std::uint32_t contacts, bool closed, Bounce bounce) {
    const std::uint64_t now_ps = agenda_.now_ps();
    for (unsigned contact = 0; contact < 32; ++contact) {
        if (!(contacts >> contact & 1)) continue;
        for (auto it = pending_.begin(); it != pending_.end();)  // an older bounce ends here
            it = it->second.contact == contact ? pending_.erase(it) : std::next(it);
        pending_.insert({now_ps, {contact, closed}});
        if (bounce.within_ns < 2) continue;
        std::set<std::uint64_t> bounces_ns;
        const std::uint64_t pairs = std::min(1 + random(bounce.most), bounce.within_ns / 2);
        while (bounces_ns.size() < 2 * pairs) bounces_ns.insert(1 + random(bounce.within_ns));
        bool now = closed;
        for (const std::uint64_t ns : bounces_ns) {
            now = !now;
            pending_.insert({now_ps + ns * 1000, {contact, now}});
        }
    }
    if (!pending_.empty()) next_.set(pending_.begin()->first);
}

void BouncingContacts::step() {
    while (!pending_.empty() && pending_.begin()->first <= agenda_.now_ps()) {
        const Change change = pending_.begin()->second;
        pending_.erase(pending_.begin());
        const std::uint32_t bit = 1u << change.contact;
        closed_ = change.closed ? closed_ | bit : closed_ & ~bit;
    }
    moved_();
    if (!pending_.empty()) next_.set(pending_.begin()->first);
}

}  // namespace sim
