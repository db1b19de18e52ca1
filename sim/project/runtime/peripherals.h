// peripherals.h - the processor's peripherals that have signals in the design, which gives and gets
// their levels through DPI (rtl/ip/de1sim_hps_wires.vh)
//
// They are of all models of the process: a DPI function has no other context.
#pragma once

#include <cstdint>

#include "sim/project/model.h"
#include "sim/project/runtime/design.h"

namespace sim::project {

class DesignPeripherals {
public:
    // Before the design is evaluated for the first time.
    explicit DesignPeripherals(const PlacedUart* placed);

    bool has(Peripheral which) const;
    // Calls `wires` with the levels that they have, and in tell() with those that have moved.
    void connect(ProcessorWires& wires, std::uint64_t now_ps);
    // Returns whether the level to the design is another now, which an evaluation has to show it.
    bool drive(Peripheral which, std::uint64_t levels);
    // After each evaluation.
    void tell(std::uint64_t now_ps) {
        if (have_moved) tell_moved(now_ps);
    }

    static bool have_moved;  // since somebody was told

private:
    void tell_moved(std::uint64_t now_ps);

    ProcessorWires* wires_ = nullptr;
};

}  // namespace sim::project
