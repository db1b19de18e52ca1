// pin_clocks.h - outputs of PLLs that go to pins of the chip and nowhere else.
//
// Nothing in the design changes at the edges of such a clock, so that none need be evaluated.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <pugixml.hpp>

namespace sim::project {

class PinClocks {
public:
    using PortBit = std::pair<std::string, int>;  // of the top; bit 0 is the rightmost

    // `netlist`: of syntax_tree(), which has to outlive this.
    explicit PinClocks(const pugi::xml_node& netlist);

    // What copies of de1sim_pll_tap drive, from the name of their module; nothing if anything but
    // a pin may depend on it.  On its way it passes assignments and ports as it is, and in a model
    // of a PLL one AND, by which a reset holds it low.
    std::optional<std::vector<PortBit>> driven_by(const std::string& tap) const;

private:
    using Node = pugi::xml_node;
    struct Net {
        Node var;
        int bit;
    };
    class Path;

    int width_of(const Node& expression) const;
    std::vector<Net> nets_of(const Node& target) const;

    std::map<std::string, int> widths_;                    // of types, by their id
    std::map<std::string, Node> modules_;                  // by name
    std::map<std::string, std::vector<Node>> instances_;   // by the module's name
    std::map<std::size_t, std::vector<Node>> references_;  // by the variable
    std::set<std::string> seen_from_outside_;              // by a hierarchical name
};

}  // namespace sim::project
