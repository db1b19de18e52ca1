// netlist_reader.h - the variables of one module of a netlist, and who drives and reads them.
#pragma once

#include "sim/project/quartus/netlist.h"

namespace sim::project {

// `node` is the module's in the XML, whose types the netlist knows already.
void read_module(const Netlist& netlist, NetModule& module, const pugi::xml_node& node);

}  // namespace sim::project
