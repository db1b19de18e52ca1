// vhdl_ports.h - ports of entities in whatever case Verilog names them
#pragma once

#include <string>
#include <vector>

#include "sim/vhdl/vhdl_generics.h"

namespace sim::project {

// Verilog, in which instances of entities name their ports as the entity does: VHDL has no case,
// so .reg1(x) connects REG1.
std::string with_ports_of_entities(const std::string& verilog,
                                   const std::vector<GenericEntity>& entities);

}  // namespace sim::project
