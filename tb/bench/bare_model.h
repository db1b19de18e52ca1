// bare_model.h - the Verilated fpga.v in a plain loop: nothing drives it, nobody looks.
#pragma once

#include <cstdint>

namespace bench {

// Wall seconds for so many clocks after the reset, the input pins idle, no output read.
double bare_model_s(std::uint64_t clocks);

}  // namespace bench
