// blocks.h - what Quartus warns of in always blocks: latches, lists, cases.
#pragma once

#include <functional>

#include "sim/project/quartus/netlist.h"
#include "sim/verilog/quartus/message.h"

namespace sim::project {

// A line of a source, for words that the XML has not (always_latch, unique, casez).
using SourceLine = std::function<std::string(const std::string& file, unsigned line)>;

// 10199, 10235, 10240, 10270, 10272, 10762, 332060.
Messages block_warnings(const Netlist& netlist, const SourceLine& line_of_source);

// "q (ring.v:7), r (ring.v:9)": what blocks without an edge read before they assign it.
std::string self_reading(const Netlist& netlist);

}  // namespace sim::project
