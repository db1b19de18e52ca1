// init_text.h - the files that a design's own memories begin with, as its Verilog names them.
//
//   $readmemh("x.hex", m)                                       also $readmemb
//   (* ram_init_file = "x.mif" *) reg [7:0] m [0:255];
//   reg [7:0] m [0:255] /* synthesis ram_init_file = "x.mif" */;    also with //
#pragma once

#include <string>
#include <vector>

#include "sim/verilog/part_drivers.h"
#include "sim/verilog/tokens.h"

namespace sim::project {

struct InitName {
    std::string name;  // as written
    unsigned line;
    std::string module, reader;  // that names it, and by what: $readmemh, $readmemb, ram_init_file
};

// Lets them be read at run time, from wherever they are.  Returns those whose names are literals.
std::vector<InitName> read_at_run_time(const Tokens& tokens, Edits& edits);

}  // namespace sim::project
