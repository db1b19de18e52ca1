// inout_fits.h - inout ports, and outputs, that are connected with more or fewer bits than they
// have.
//
//   .data(DQ)     of 16 bits with a wire of 1 bit becomes    .data({de1sim_open_1, DQ})
//   .data(bus)    of 8 bits with a wire of 16 bits becomes   .data(bus[7:0])
//
// Quartus warns and does the same.  Verilator refuses it, with the line and the numbers of bits.
// So with outputs whose wire has more bits, of which others have another driver.
//
// Not handled: wires whose lowest bit has another number than 0; two such instances in one line.
#pragma once

#include <string>
#include <vector>

#include "sim/verilog/edits.h"
#include "sim/verilog/instances.h"
#include "sim/verilog/tokens.h"

namespace sim::project {

struct InoutFit {
    unsigned line;  // of the connection
    std::string port;
    unsigned bits, connected;  // of the port, and of the wire
};

void fit_inouts(const std::vector<Token>& tokens, const Modules& modules,
                const std::vector<InoutFit>& fits, Edits& edits);

}  // namespace sim::project
