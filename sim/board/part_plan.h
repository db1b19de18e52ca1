// part_plan.h - what a scenario hangs on the headers' pins: one of its `parts:`
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "sim/board/header_part.h"

namespace sim {

struct PartPlan {
    std::string kind;  // "led-matrix", as a scenario names it
    std::string name;
    HeaderPinList pins;    // that it alone has
    HeaderPinList shared;  // that others with the same list may have, too
    // Makes the part.  Empty for one that belongs to the board, wherever it hangs.
    std::function<std::unique_ptr<HeaderPart>(const PartSocket&)> hang = {};
    unsigned rows = 0, columns = 0;  // of its LEDs
    bool is_display = false;         // HeaderPart::picture() has something
    // What a person does to it, for the page of a live run: steps on it by its name.
    struct Control {
        std::function<std::string(const std::string& name, bool on)> step;  // in JSON
        bool stays = false;  // on after it is let go of, as a switch is
    };
    std::optional<Control> control = {};
    int line = 0, column = 0;  // in the scenario's file
};

}  // namespace sim
