// vhdl_library.h - the libraries that VHDL has of Intel's IP: components of the models in rtl/ip.
//
//   library lpm; use lpm.lpm_components.all;                       lpm_mult, lpm_counter ...
//   library altera_mf; use altera_mf.altera_mf_components.all;     altsyncram, altpll, scfifo ...
//   library altera; use altera.altera_primitives_components.all;   dff, lcell ..., also maxplus2
//   library altera; use altera.altera_syn_attributes.all;          keep, preserve, chip_pin ...
//   library altera_lnsim; use altera_lnsim.altera_lnsim_components.all;   altera_pll ...
//   library cyclonev; use cyclonev.cyclonev_components.all;   the processor's primitives
//
// They are read from the models' text.  A parameter is a generic, STRING or NATURAL by its default.
// A port has the default of defaults.tsv, or 0; where its name is a word of VHDL, "a_" comes before
// it, as in Intel's libraries: a_in.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "sim/verilog/normalise.h"

namespace sim::project {

// The text of each library, by its name.  `models` is rtl/ip.
std::map<std::string, std::string> vhdl_libraries(const std::filesystem::path& models,
                                                  const OpenInputs& ones);

}  // namespace sim::project
