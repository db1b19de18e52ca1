// header_wires.h - the wires of the headers, joined by the keypad where it hangs on them
//
// A wire on which two drivers disagree is reported once.
//
// Not handled: disagreement by way of the keypad's contacts.
#pragma once

#include <array>
#include <functional>
#include <string>

#include "sim/board/header.h"
#include "sim/pins/header_pin.h"

namespace sim {

class HeaderWires {
public:
    // The levels of the keypad's D7 to D0, given what drives them and where (1 = driven).
    using Join = std::function<std::uint8_t(std::uint8_t driven, std::uint8_t enable)>;

    // `keypad_pins`: where its D7 to D0 are.
    HeaderWires(Join keypad, const HeaderPinList& keypad_pins,
                std::function<void(const std::string& line)> log);

    void fpga(const HeaderPins& pins);
    void hand(const HeaderMasks& pins, PinLevel level);
    void part(const HeaderMasks& pins, PinLevel level);

    // Looks at the drivers and at the keypad again.
    const HeaderMasks& settle();

    const HeaderMasks& levels() const { return levels_; }
    std::uint64_t outputs(unsigned header) const { return headers_[header].outputs(); }

private:
    void join();
    void report_conflicts(unsigned header, std::uint64_t conflicts);

    std::array<Header, HEADERS> headers_;
    const Join keypad_;
    const HeaderPinList keypad_pins_;
    const std::function<void(const std::string&)> log_;
    HeaderMasks levels_ = all_header_pins();
    HeaderMasks reported_{};
};

}  // namespace sim
