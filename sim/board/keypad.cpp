#include "sim/board/keypad.h"

namespace sim {

namespace {

constexpr BouncingContacts::Bounce BOUNCE{6, 5'000'000};

std::uint8_t column_wire(unsigned key) { return static_cast<std::uint8_t>(0x80 >> key % 4); }
std::uint8_t row_wire(unsigned key) { return static_cast<std::uint8_t>(0x08 >> key / 4); }

}  // namespace

Keypad::Keypad(Agenda& agenda, std::uint64_t seed, std::function<void()> moved)
    : contacts_{agenda, seed, std::move(moved)} {}

void Keypad::press(std::uint16_t keys) {
    contacts_.move(keys, true, BOUNCE);
    for (unsigned key = 0; key < 16; ++key) presses_ += keys >> key & 1;
}

void Keypad::release(std::uint16_t keys) {
    contacts_.move(keys, false, BOUNCE);
    for (unsigned key = 0; key < 16; ++key) releases_ += keys >> key & 1;
}

std::uint8_t Keypad::levels(std::uint8_t driven, std::uint8_t enable) const {
    std::uint8_t low = static_cast<std::uint8_t>(enable & ~driven);
    const std::uint32_t closed = contacts_.closed();
    if (!closed) return static_cast<std::uint8_t>(~low);
    for (std::uint8_t before = static_cast<std::uint8_t>(~low); before != low;) {
        before = low;
        for (unsigned key = 0; key < 16; ++key) {
            const auto wires = static_cast<std::uint8_t>(column_wire(key) | row_wire(key));
            if (closed >> key & 1 && low & wires) low |= wires;
        }
    }
    return static_cast<std::uint8_t>(~low);
}

}  // namespace sim
