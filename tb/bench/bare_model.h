// bare_model.h - the Verilated fpga.v in a plain loop: inputs idle, outputs not read.
#pragma once

#include <cstdint>

namespace bench {

// Clocks after a reset until the codec is set up: 20 ms, a frame and a bit.
constexpr std::uint64_t CLOCKS_OF_SET_UP = 500'000;

// Wall seconds for so many clocks after that, the input pins idle, no output read.  With `skip`
// clocks in which nothing happens are left out, as sim/fpga/fabric.cpp does.
double bare_model_s(std::uint64_t clocks, bool skip);

}  // namespace bench
