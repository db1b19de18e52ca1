// bus_cost.h - host time of the firmware's accesses.
#pragma once

namespace bench {

// Through b_transport, the AXI pins and the RTL, including the clocks that pass.
struct BusCost {
    double register_read_ns;
    double register_write_ns;
    double burst_write_ns_a_word;  // rows of 160 words into the picture
    double burst_read_ns_a_word;
};

// Elaborates SystemC: call it once per process.
BusCost bus_cost();

}  // namespace bench
