// vhdl_generics.h - an entity whose generics Verilog sets: foo #(.WIDTH(8)) u (...);
//
// Each set of values is translated alone, as foo_de1sim_0, foo_de1sim_1 ...; foo is a module in
// Verilog with the generics as parameters, which instances the one of its values.  Which values
// there are is known when Verilator has elaborated the design.
//
// Not handled: generics of other types than numbers, boolean, bits, vectors of bits, and strings.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim/verilog/top_parameters.h"
#include "sim/vhdl/vhdl_source.h"

namespace sim::project {

using ParameterSet = std::map<std::string, std::string>;  // name and value: 32'sh8, "text"

struct GenericEntity {
    EntityHead head;
    std::string name, file;  // as Verilog writes it; for messages
    bool is_set = false;     // Verilog gives generics values, so that there is a wrapper
    std::vector<ParameterSet> sets;

    std::string module(std::size_t set) const;  // foo_de1sim_0
    // For GHDL: -gWIDTH=8, but for what has its default.  ProjectError: a type that it cannot set.
    std::vector<std::string> options(std::size_t set) const;
    // `modules`: the Verilog of each set.
    std::string wrapper(const std::vector<std::string>& modules) const;
    // VHDL has no case: those that are generics get the names that count in the wrapper.
    TopParameters with_its_names(const TopParameters& parameters) const;
    // Takes the values that are new, and says whether there were any.
    bool add(const std::vector<ParameterSet>& found);
    // GHDL has inputs first; Verilog may connect them in the order of the entity.
    std::string in_order(const std::string& module) const;
};

bool is_generic(const EntityHead& head, const std::string& name);

}  // namespace sim::project
