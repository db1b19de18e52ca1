#include "sim/board/parts.h"

namespace sim {

namespace {

// A button closes a wire to ground or to 3.3 V; in the second case a resistor pulls it low else.
PinLevel level_of(const PartPlan& contact, bool closed) {
    if (contact.kind == PartPlan::Kind::SWITCH || contact.high)
        return closed ? PinLevel::HIGH : PinLevel::LOW;
    return closed ? PinLevel::LOW : PinLevel::RELEASED;
}

}  // namespace

Parts::Parts(const std::vector<PartPlan>& plans, Agenda& agenda, Drive drive,
             std::function<void()> moved)
    : drive_{std::move(drive)} {
    for (const PartPlan& plan : plans) switch (plan.kind) {
            case PartPlan::Kind::BUTTON:
            case PartPlan::Kind::SWITCH:
                contacts_.emplace(plan.name, plan);
                close(plan.name, false);
                break;
            case PartPlan::Kind::LED:
            case PartPlan::Kind::LED_MATRIX: leds_.emplace(plan.name, LedMatrix{plan}); break;
            case PartPlan::Kind::LT24: lt24_.emplace(plan.pins.front() / PINS_OF_A_HEADER); break;
            case PartPlan::Kind::TERMINAL: {
                const HeaderMasks tx = mask_of({plan.pins.at(1)});
                drive_(tx, PinLevel::HIGH);
                terminals_.try_emplace(plan.name, plan.pins.at(0), agenda, plan.baud,
                                       [this, tx, moved](bool level) {
                                           drive_(tx, level ? PinLevel::HIGH : PinLevel::LOW);
                                           moved();
                                       });
                break;
            }
            case PartPlan::Kind::KEYPAD: break;  // a part of the board, wherever it hangs
        }
}

void Parts::close(const std::string& contact, bool closed) {
    const PartPlan& plan = contacts_.at(contact);
    drive_(mask_of(plan.pins), level_of(plan, closed));
}

HeaderPinList keypad_pins(const std::vector<PartPlan>& plans) {
    for (const PartPlan& plan : plans)
        if (plan.kind == PartPlan::Kind::KEYPAD) return plan.pins;
    return {9, 8, 7, 6, 5, 4, 3, 1};  // header_bits.h
}

}  // namespace sim
