// clock_uses.h - who sees a clock: registers at its rise, pins of the chip, or anything else.
//
// Of a clock that only pins see no edge need be evaluated; of one that only registers see at its
// rise, the fall need not.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <pugixml.hpp>

namespace sim::project {

class ClockUses {
public:
    using PortBit = std::pair<std::string, int>;  // of the top; bit 0 is the rightmost

    // `netlist`: of syntax_tree(), which has to outlive this.
    explicit ClockUses(const pugi::xml_node& netlist);

    struct Use {
        bool rises = false;  // something happens at its rise
        bool locks = false;  // a PLL counts its rises until it is locked (de1sim_pll_lock.v)
        std::vector<PortBit> pins{};  // of the top, that follow it
    };
    // Of what copies of de1sim_pll_tap drive, from the name of their module, or of a port of one
    // bit by which the top gets it; nothing if something else may depend on it.  On its way it
    // passes assignments and ports as it is, and in a model of a PLL one AND, by which a reset
    // holds it low.
    std::optional<Use> of_tap(const std::string& tap) const;
    std::optional<Use> of_input(const pugi::xml_node& port) const;

private:
    using Node = pugi::xml_node;
    struct Net {
        Node var;
        int bit;
    };
    class Path;

    int width_of(const Node& expression) const;
    Node variable_of(const Node& reference) const;
    std::vector<Net> nets_of(const Node& target) const;

    std::map<std::string, int> widths_;                              // of types, by their id
    std::map<std::string, Node> modules_;                            // by name
    std::map<std::string, std::vector<Node>> instances_;             // by the module's name
    std::map<std::pair<std::size_t, std::string>, Node> variables_;  // by their block and name
    std::map<std::size_t, std::vector<Node>> references_;            // by the variable
    std::set<std::string> seen_from_outside_;                        // by a hierarchical name
};

}  // namespace sim::project
