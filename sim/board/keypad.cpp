#include "sim/board/keypad.h"

namespace sim {

namespace {

constexpr unsigned BOUNCE_NS = 5'000'000;

std::uint8_t column_wire(unsigned key) { return static_cast<std::uint8_t>(0x80 >> key % 4); }
std::uint8_t row_wire(unsigned key) { return static_cast<std::uint8_t>(0x08 >> key / 4); }

}  // namespace

Keypad::Keypad(Agenda& agenda, std::uint64_t seed, std::function<void()> moved)
    : agenda_{agenda}, moved_{std::move(moved)}, random_{seed} {}

void Keypad::press(std::uint16_t keys) {
    move(keys, true);
    for (unsigned key = 0; key < 16; ++key) presses_ += keys >> key & 1;
}

void Keypad::release(std::uint16_t keys) {
    move(keys, false);
    for (unsigned key = 0; key < 16; ++key) releases_ += keys >> key & 1;
}

void Keypad::move(std::uint16_t keys, bool closed) {
    const std::uint64_t now_ps = agenda_.now_ps();
    for (unsigned key = 0; key < 16; ++key) {
        if (!(keys >> key & 1)) continue;
        for (auto it = pending_.begin(); it != pending_.end();)  // an older bounce ends here
            it = it->second.key == key ? pending_.erase(it) : std::next(it);
        pending_.insert({now_ps, {key, closed}});
        std::map<unsigned, bool> bounce;  // time in ns: sorted, and each once
        const unsigned pairs = 1 + random(6);
        while (bounce.size() < 2 * pairs) bounce[1 + random(BOUNCE_NS)] = false;
        bool now = closed;
        for (const auto& [ns, unused] : bounce) {
            now = !now;
            pending_.insert({now_ps + ns * std::uint64_t{1000}, {key, now}});
        }
    }
    next_.set(now_ps);
}

void Keypad::step() {
    while (!pending_.empty() && pending_.begin()->first <= agenda_.now_ps()) {
        const Contact contact = pending_.begin()->second;
        pending_.erase(pending_.begin());
        const auto bit = static_cast<std::uint16_t>(1u << contact.key);
        closed_ = static_cast<std::uint16_t>(contact.closed ? closed_ | bit : closed_ & ~bit);
    }
    moved_();
    if (!pending_.empty()) next_.set(pending_.begin()->first);
}

std::uint8_t Keypad::levels(std::uint8_t driven, std::uint8_t enable) const {
    std::uint8_t low = static_cast<std::uint8_t>(enable & ~driven);
    if (!closed_) return static_cast<std::uint8_t>(~low);
    for (std::uint8_t before = static_cast<std::uint8_t>(~low); before != low;) {
        before = low;
        for (unsigned key = 0; key < 16; ++key) {
            const auto wires = static_cast<std::uint8_t>(column_wire(key) | row_wire(key));
            if (closed_ >> key & 1 && low & wires) low |= wires;
        }
    }
    return static_cast<std::uint8_t>(~low);
}

}  // namespace sim
