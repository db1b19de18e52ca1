// fabric_wires.h - the signals of a peripheral where they are routed to the FPGA, not to pins
//
// The design runs behind the processor.  `catch_up` lets it come to this time, and tells the
// peripheral what has moved at its signals until then, each with its time.  `drive` gives it new
// levels at this time.  The bits are those of Peripheral in sim/pins/fpga_model.h.
#pragma once

#include <cstdint>
#include <functional>

#include <systemc>

namespace sim {

struct FabricWires {
    std::function<void(std::uint64_t levels, const sc_core::sc_time& now)> drive;
    std::function<void(const sc_core::sc_time& until)> catch_up;
};

}  // namespace sim
