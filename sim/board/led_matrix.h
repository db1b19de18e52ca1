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

#include "sim/board/lamp.h"
#include "sim/board/part_plan.h"

namespace sim {

class LedMatrix {
public:
    explicit LedMatrix(const PartPlan& plan);

    const std::string& name() const { return plan_.name; }

    // The wires have these levels from now on.
    void look(const HeaderMasks& levels, std::uint64_t time_ps);

    bool lit(std::uint64_t time_ps);  // the first LED
    // A line per row: `#` is lit, `+` has less than a third of the brightest one's light, `.` is
    // dark.
    std::vector<std::string> picture(std::uint64_t time_ps);

private:
    std::uint64_t shown_rows(const HeaderMasks& levels) const;

    const PartPlan plan_;
    const HeaderMasks wires_;
    const unsigned width_;
    HeaderMasks levels_here_{};
    bool looked_ = false;
    std::vector<std::uint64_t> lit_;  // by row, bit n is column n
    LampBank lamps_;
};

}  // namespace sim
