// vhdl_library.h - the libraries that VHDL has of Intel's IP: components of the models in rtl/ip.
//
//   library lpm; use lpm.lpm_components.all;                       lpm_mult, lpm_counter ...
//   library altera_mf; use altera_mf.altera_mf_components.all;     altsyncram, altpll, scfifo ...
//   library altera; use altera.altera_primitives_components.all;   dff, lcell, global ...
//   library altera_lnsim; use altera_lnsim.altera_lnsim_components.all;   altera_pll
//
// They are read from the models' text.  A parameter is a generic, STRING or NATURAL by its default.
// A port has the default of defaults.tsv, or 0; where its name is a word of VHDL, "a_" comes before
// it, as in Intel's libraries: a_in.
//
// Not handled: a model with ranges that VHDL does not have (altsource_probe).
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
