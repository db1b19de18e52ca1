// bridge.h - the burst that is under way over one of the processor's bridges, as the design gets it
// through DPI (rtl/ip/de1sim_hps_bridge.vh)
#pragma once

#include <cstdint>
#include <string>

#include "sim/project/model.h"

namespace sim::project {

// Of all models of the process: a DPI function has no other context.
extern BridgeBurst bridge_burst;

// For what it waits, by a bridge's 20 bits of hps_waits_o: from bit 0 on a code, the ID or
// the beat that was seen with it, and the beat.
std::string bridge_waits_for(std::uint64_t waits);

}  // namespace sim::project
