#include "sim/board/header_wires.h"

#include <algorithm>

#include <fmt/format.h>

namespace sim {

namespace {

// The keypad has D7 in bit 7.
HeaderPinList d0_first(HeaderPinList d7_first) {
    std::reverse(d7_first.begin(), d7_first.end());
    return d7_first;
}

}  // namespace

HeaderWires::HeaderWires(Join keypad, const HeaderPinList& keypad_pins,
                         std::function<void(const std::string& line)> log)
    : keypad_{std::move(keypad)}, keypad_pins_{d0_first(keypad_pins)}, log_{std::move(log)} {}

void HeaderWires::fpga(const HeaderPins& pins) {
    for (unsigned n = 0; n < HEADERS; ++n) headers_[n].fpga(pins.levels[n], pins.enable[n]);
}

void HeaderWires::hand(const HeaderMasks& pins, PinLevel level) {
    for (unsigned n = 0; n < HEADERS; ++n) headers_[n].hand(pins[n], level);
}

void HeaderWires::part(const HeaderMasks& pins, PinLevel level) {
    for (unsigned n = 0; n < HEADERS; ++n) headers_[n].part(pins[n], level);
}

const HeaderMasks& HeaderWires::settle() {
    for (unsigned n = 0; n < HEADERS; ++n) {
        levels_[n] = headers_[n].levels();
        const std::uint64_t conflicts = headers_[n].conflicts() & ~reported_[n];
        if (conflicts) report_conflicts(n, conflicts);
    }
    join();
    return levels_;
}

void HeaderWires::join() {
    HeaderMasks driven{};
    for (unsigned n = 0; n < HEADERS; ++n) driven[n] = headers_[n].driven();
    const std::uint8_t joined = keypad_(static_cast<std::uint8_t>(gathered(levels_, keypad_pins_)),
                                        static_cast<std::uint8_t>(gathered(driven, keypad_pins_)));
    for (unsigned n = 0; n < keypad_pins_.size(); ++n)
        if (!(joined >> n & 1))
            levels_[keypad_pins_[n] / PINS_OF_A_HEADER] &=
                ~(std::uint64_t{1} << keypad_pins_[n] % PINS_OF_A_HEADER);
}

void HeaderWires::report_conflicts(unsigned header, std::uint64_t conflicts) {
    reported_[header] |= conflicts;
    for (unsigned pin = 0; pin < PINS_OF_A_HEADER; ++pin)
        if (conflicts >> pin & 1)
            log_(fmt::format("{} is driven high and low at once; on a board that may damage it",
                             pin_name(header * PINS_OF_A_HEADER + pin)));
}

}  // namespace sim
