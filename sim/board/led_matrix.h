// led_matrix.h - LEDs between row and column wires, as a person sees them; one LED is 1 x 1
//
// An LED is lit while its row and its column both have the level that lights it.  Rows are shown
// one after the other as a rule, so a picture takes the brightest LED as the measure of the others.
// Where a decoder on the LED board selects the row, its wires are a number.
//
// Not handled: the current through pull-ups, which lights an LED a little; the resistors that are
// missing where several LEDs share one.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/board/header_part.h"
#include "sim/board/lamp.h"

namespace sim {

class LedMatrix : public HeaderPart {
public:
    struct Wiring {
        HeaderPinList rows;                       // from the top
        HeaderPinList columns;                    // from the left; none: one LED per row
        bool row_lit = true, column_lit = false;  // the levels that light an LED
        // The pins of `rows` are a number, bit 0 last: the row that is shown, 0 at the top.
        bool coded_rows = false;

        unsigned row_count() const {
            return static_cast<unsigned>(coded_rows ? std::size_t{1} << rows.size() : rows.size());
        }
    };
    explicit LedMatrix(Wiring wiring);

    void look(const HeaderMasks& levels, std::uint64_t time_ps) override;

    bool lit(std::uint64_t time_ps);  // the first LED
    std::vector<std::string> rows(std::uint64_t time_ps) override;

private:
    std::uint64_t shown_rows(const HeaderMasks& levels) const;

    const Wiring wiring_;
    const HeaderMasks wires_;
    const unsigned width_;
    HeaderMasks levels_here_{};
    bool looked_ = false;
    std::vector<std::uint64_t> lit_;  // by row, bit n is column n
    LampBank lamps_;
};

}  // namespace sim
