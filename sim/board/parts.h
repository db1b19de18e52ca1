// parts.h - the parts that a scenario hangs on the headers, by their names
//
// Not handled: bounce of a button's contact.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/board/header.h"
#include "sim/board/led_matrix.h"
#include "sim/board/lt24.h"
#include "sim/board/part_plan.h"
#include "sim/board/serial_terminal.h"

namespace sim {

class Parts {
public:
    using Drive = std::function<void(const HeaderMasks& pins, PinLevel level)>;

    // `drive` puts a level on pins, until the next call; `moved` is called after a part has driven
    // pins at a time of its own.
    Parts(const std::vector<PartPlan>& plans, Agenda& agenda, Drive drive,
          std::function<void()> moved);

    // What is on the wires from now on.
    void look(const HeaderMasks& levels, std::uint64_t time_ps) {
        for (auto& [name, leds] : leds_) leds.look(levels, time_ps);
        if (lt24_) lt24_->look(levels);
        for (auto& [name, wired] : terminals_) wired.terminal.look(is_high(levels, wired.rx));
    }

    bool is_button(const std::string& contact) const {
        return contacts_.at(contact).kind == PartPlan::Kind::BUTTON;
    }
    // Presses a button or moves a switch to high; or lets go of it, moves it to low.
    void close(const std::string& contact, bool closed);

    // An LED or a matrix.
    LedMatrix& leds(const std::string& name) { return leds_.at(name); }
    std::map<std::string, LedMatrix>& all_leds() { return leds_; }

    SerialTerminal& terminal(const std::string& name) { return terminals_.at(name).terminal; }
    // With the name and the terminal of each.
    template <class Action>
    void for_each_terminal(Action action) {
        for (auto& [name, wired] : terminals_) action(name, wired.terminal);
    }

    const Lt24& lt24() const { return lt24_.value(); }

private:
    struct WiredTerminal {
        HeaderPin rx;
        SerialTerminal terminal;

        WiredTerminal(HeaderPin on, Agenda& agenda, unsigned baud, std::function<void(bool)> drive)
            : rx{on}, terminal{agenda, baud, std::move(drive)} {}
    };

    const Drive drive_;
    std::map<std::string, WiredTerminal> terminals_;
    std::map<std::string, PartPlan> contacts_;
    std::map<std::string, LedMatrix> leds_;
    std::optional<Lt24> lt24_;
};

// Where the keypad's D7 to D0 are: JP1 D7 to D0, unless it is among the parts.
HeaderPinList keypad_pins(const std::vector<PartPlan>& plans);

}  // namespace sim
