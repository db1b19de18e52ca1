// board_parts.h - what a board has of all that a scenario can act on and look at.
#pragma once

#include <map>
#include <set>
#include <string>

namespace sim {

struct BoardParts {
    std::string name;             // "DE10-Lite"; empty: not known, and all is taken to be there
    std::set<std::string> wires;  // of the simulated chip: "KEY[1]", "GPIO_0[3]"; "HPS"
    // As the board's schematic calls wires with another name: "LEDR" is "LED".
    std::map<std::string, std::string> names = {};

    bool has(const std::string& wire) const { return name.empty() || wires.count(wire) > 0; }
};

}  // namespace sim
