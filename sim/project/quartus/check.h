// check.h - all that Quartus would say of a design, from what is known of it here.
#pragma once

#include <map>
#include <string>

#include "sim/project/elaborated.h"
#include "sim/project/project.h"
#include "sim/verilog/quartus/message.h"
#include "sim/verilog/quartus/text_checks.h"

namespace sim::project {

struct CheckRequest {
    const Project& project;
    std::string tree_file;                           // of Verilator, with -O0
    const std::string& output;                       // by Verilator while it wrote that
    const std::map<std::string, TextChecks>& texts;  // by the file's name in messages
    const std::vector<Port>& ports;                  // of the top
};

struct Checked {
    Messages errors, warnings;  // sorted, each once
    std::string self_reading;   // "q (ring.v:7)": variables without a register that read themselves
};

// What Quartus refuses of the files' texts, without an elaborated design; sorted, each once.
Messages text_errors(const std::map<std::string, TextChecks>& texts);

Checked check_design(const CheckRequest& request);

}  // namespace sim::project
