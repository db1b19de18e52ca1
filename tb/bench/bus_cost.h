// bus_cost.h - what the firmware's accesses cost the simulating machine.
#pragma once

namespace bench {

// Through b_transport, the AXI pins and the RTL, the clocks that go by included.
struct BusCost {
    double register_read_ns;
    double register_write_ns;
    double burst_write_ns_a_word;  // rows of 160 words into the picture
    double burst_read_ns_a_word;
};

// Elaborates SystemC: once a process.
BusCost bus_cost();

}  // namespace bench
