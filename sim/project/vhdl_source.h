// vhdl_source.h - what a VHDL file defines and what it wants, found without analysing it.
#pragma once

#include <string_view>

#include "sim/project/source.h"

namespace sim::project {

// Entities, what they want (components, entities), and their ports.
SourceText scan_vhdl(std::string_view text);

}  // namespace sim::project
