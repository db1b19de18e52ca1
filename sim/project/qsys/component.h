// component.h - a kind of module of Platform Designer, as its description (_hw.tcl) has it
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace sim::project::qsys {

constexpr unsigned WIDEST_PORT = 4'096;

struct Port {
    enum class Direction { INPUT, OUTPUT, BIDIR };
    std::string name, role;
    Direction direction;
    unsigned width;
    bool is_vector;  // also where the width is 1
};

struct Interface {
    std::string name;
    std::string type;  // clock, reset, avalon, interrupt, conduit, avalon_streaming
    bool is_start;     // it drives the others: master, source, start; an interrupt's receiver
    std::map<std::string, std::string> properties;
    std::vector<Port> ports;

    // The property, or what it is by default.
    std::string property(const std::string& property_name, const std::string& otherwise = {}) const;
    unsigned number(const std::string& property_name, unsigned otherwise) const;
    const Port* port(const std::string& role) const;  // null: it has none
};

struct ComponentFile {
    std::string path;      // from the _hw.tcl's folder on
    std::string type;      // VERILOG, SYSTEM_VERILOG, VHDL, SDC, OTHER ...
    bool has_top = false;  // TOP_LEVEL_FILE: it defines the module
};

struct Component {
    std::filesystem::path file;  // that describes it
    std::string kind, version;
    std::string module;  // in Verilog or VHDL; empty: it has none
    std::vector<ComponentFile> files;
    std::map<std::string, std::string> parameters;  // of the module: its HDL parameters, Verilog
    std::vector<Interface> interfaces;
    std::map<std::string, std::string> assignments;  // "embeddedsw.dts.vendor"
    std::vector<std::string> notes;

    const Interface* interface(const std::string& name) const;  // null: it has none
};

using Parameters = std::map<std::string, std::string>;  // of an instance

// Runs the _hw.tcl, with its callbacks, for an instance with these parameters.  ProjectError: wrong
// Tcl, with its line; a command that the description of a component has not; a message of kind
// `error`.
Component read_component(const std::filesystem::path& hw_tcl, const Parameters& parameters,
                         const std::string& instance);
// The same of the text; `file` stands in messages.
Component component_in(const std::string& text, const std::filesystem::path& file,
                       const Parameters& parameters, const std::string& instance);

}  // namespace sim::project::qsys
