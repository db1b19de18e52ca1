// top_parameters.h - parameters of the top module that the .qsf sets: set_parameter -name WIDTH 8
#pragma once

#include <map>
#include <string>
#include <vector>

namespace sim::project {

struct TopParameter {
    std::string value;  // as Verilog writes it
    std::string place;  // where it is set: "pong.qsf:12"
};
using TopParameters = std::map<std::string, TopParameter>;  // by name

// Quartus' value as Verilog's: a number stays, true and false are 1 and 0, all else is a string.
std::string verilog_value(const std::string& value);

// For Verilator, where the top is the project's: -GWIDTH=8
std::vector<std::string> verilator_options(const TopParameters& parameters);

// The names of which Verilator says that the top has no such parameter; none: it says something
// else.
std::vector<std::string> unknown_parameters(const std::string& output);

// For an instance of the top: " #(.WIDTH (8))", or nothing.
std::string instance_text(const TopParameters& parameters);

}  // namespace sim::project
