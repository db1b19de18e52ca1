// keypad.h - a 4 x 4 keypad: 16 switches on eight wires, with bouncing contacts and no diodes.
//
//            D7   D6   D5   D4      columns, left to right
//      D3     1    2    3    A      A closed switch joins its row's and its column's wire.  Joined
//      D2     4    5    6    B      wires have one level: low if one is pulled low, else high by
//      D1     7    8    9    C      pull-ups.  So three corners of a rectangle close the path of
//      D0     0    F    E    D      the fourth, in both directions.
//
// A contact that closes or opens bounces 1 to 6 times, for up to 5 ms (bouncing_contacts.h).
//
// Not handled: contact resistance; contention.  A wire that one output drives high and another low
// is low here; on a board it may damage a pin.
#pragma once

#include <cstdint>
#include <functional>

#include "sim/board/bouncing_contacts.h"
#include "sim/pins/agenda.h"

namespace sim {

class Keypad {
public:
    // `moved` is called after each change of a contact.
    Keypad(Agenda& agenda, std::uint64_t seed, std::function<void()> moved);

    // Presses or releases keys, bit 4 * row + column, from agenda.now_ps() on.
    void press(std::uint16_t keys);
    void release(std::uint16_t keys);

    // Levels of D7-D0, given what drives them and where (1 = driven).
    std::uint8_t levels(std::uint8_t driven, std::uint8_t enable) const;

    std::uint64_t presses() const { return presses_; }
    std::uint64_t releases() const { return releases_; }

private:
    BouncingContacts contacts_;
    std::uint64_t presses_ = 0, releases_ = 0;
};

}  // namespace sim
