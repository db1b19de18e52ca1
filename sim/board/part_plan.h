// part_plan.h - what a scenario hangs on the headers' pins: one of its `parts:`, as data
#pragma once

#include <string>
#include <vector>

#include "sim/pins/header_pin.h"

namespace sim {

struct PartPlan {
    enum class Kind { BUTTON, SWITCH, LED, LED_MATRIX, KEYPAD, LT24, TERMINAL };

    Kind kind;
    std::string name;
    HeaderPinList pins;     // a matrix's rows from the top, or coded; the keypad's D7 to D0; a
                            // terminal's rx and tx
    HeaderPinList columns;  // of a matrix, from the left
    // The level of a button that is pressed, and of an LED or of a matrix's row that is lit.
    bool high = false;
    bool column_high = false;  // the level that lights a matrix's column
    int line = 0, column = 0;  // in the scenario's file
    // The pins of a matrix's rows are a number, bit 0 last: the row that is shown, 0 at the top.
    bool coded_rows = false;
    unsigned baud = 0;  // of a terminal

    std::size_t rows() const { return coded_rows ? std::size_t{1} << pins.size() : pins.size(); }
};

}  // namespace sim
