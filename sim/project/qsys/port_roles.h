// port_roles.h - a component that is there as Verilog alone: what its ports' names say
#pragma once

#include <string>

#include "sim/project/qsys/system.h"
#include "sim/verilog/source.h"

namespace sim::project::qsys {

// The text that its _hw.tcl would have.  The interfaces are those that the system connects or
// exports; a port belongs to the interface of whose signals it has a name, as "avs_s0_writedata",
// "write_data" or "waitrequest_n"; what is left is the exported conduit's, by the role `export`.
// Where several interfaces are possible, the port's name has the interface's in it.
//
// ProjectError: a slave or master without data, ports of which no conduit, or more than one, is
// exported.
std::string description_by_ports(const ModuleText& module, const System& system,
                                 const Instance& instance);

}  // namespace sim::project::qsys
