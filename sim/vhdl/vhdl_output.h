// vhdl_output.h - Verilog as GHDL writes it, made into what Verilator takes.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "sim/verilog/source.h"

namespace sim::project {

// The module in Verilog that a component without an entity is; null: there is none.
using InVerilog = std::function<const ModuleText*(const std::string& component)>;

// The modules of one run of GHDL.
class VhdlOutput {
public:
    // `output` is what GHDL prints of the entity `root`, which gets the name `module`.
    // ProjectError: there is no module for a component.
    VhdlOutput(const std::string& output, const std::string& root, const std::string& module,
               const InVerilog& in_verilog);

    // Those that are not in `known`, into which they go.
    std::string without(std::set<std::string>& known) const;

private:
    struct Module {
        std::string name, text;
    };
    void add(std::string text, const std::string& root, const std::string& module);

    void rename(std::string& module) const;

    std::vector<Module> modules_;
    std::map<std::string, const ModuleText*> components_;  // by their names in VHDL
};

}  // namespace sim::project
