// slave_agent.h - what joins the commands of the interconnect with a slave's own signals
#pragma once

#include <string>
#include <vector>

#include "sim/project/qsys/assembly.h"
#include "sim/project/qsys/memory_map.h"
#include "sim/project/qsys/verilog_text.h"

namespace sim::project::qsys {

// A set of wires of one command interface, as rtl/ip/qsys/de1sim_avalon_decoder.v has it:
// NAME_valid, NAME_ready and so on.
struct Bus {
    std::string name;
    unsigned width;  // bits of data
    std::string clock, reset;

    std::string is_asked() const;  // its connections to a module's ports that are asked
};

// Writes the agent as an instance `name`, and what else the slave's inputs get.  Adds a note where
// the slave can report an error, which is not passed on.
void write_slave_agent(const Assembly& assembly, VerilogText& text, const Slave& slave,
                       const Bus& from, const std::string& name, std::vector<std::string>& notes);

}  // namespace sim::project::qsys
