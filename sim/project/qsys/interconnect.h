// interconnect.h - what is between the masters and the slaves of a system, as Verilog
//
//   master -> agent -> decoder -+-> [crossing] -> [width] -+-> [arbiter] -> agent -> slave
//                               +-> ...                    |
//   master -> agent -> decoder -+--------------------------+
//
// The modules are those of rtl/ip/qsys.  A burst is a command for each word, which says how many
// are to come; the agent of a slave that takes bursts joins them again.  As in the vendor's
// interconnect an address is decoded up to the end of the highest slave, and one of nobody goes to
// the largest slave that takes such an access, of equals the lowest.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/project/qsys/assembly.h"
#include "sim/project/qsys/memory_map.h"
#include "sim/project/qsys/verilog_text.h"

namespace sim::project::qsys {

// A bridge of the processor with something behind it.
struct Bridge {
    std::uint32_t window;       // its first address, of the processor
    std::uint64_t decoded;      // bytes, after which the addresses repeat
    std::string reads, writes;  // the slave that has those of no other; empty: not known
};

struct Interconnect {
    std::vector<Place> map;
    std::vector<Bridge> bridges;
    std::vector<std::string> notes;
};

// Writes it.  ProjectError: as of MemoryMap.
Interconnect write_interconnect(const Assembly& assembly, VerilogText& text);

}  // namespace sim::project::qsys
