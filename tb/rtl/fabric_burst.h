// fabric_burst.h - a burst over one of the fabric's bridges
#pragma once

#include <cstdint>

#include "sim/pins/fpga_model.h"

namespace tb {

// A burst of words; one byte, or one aligned half-word, is narrow.
inline sim::BridgeBurst burst_of(bool full, bool write, std::uint32_t address,
                                 const std::uint8_t* data, unsigned bytes) {
    sim::BridgeBurst burst{};
    burst.full = full;
    burst.write = write;
    burst.address = address;
    burst.beats = (address + bytes - 1) / 4 - address / 4 + 1;
    burst.size = bytes == 1 ? 0 : bytes == 2 && address % 2 == 0 ? 1 : 2;
    burst.kind = 1;  // INCR
    for (unsigned n = 0; n < bytes; ++n) {
        sim::BridgeBurst::Beat& beat = burst.beat[(address + n) / 4 - address / 4];
        beat.strobes = static_cast<std::uint16_t>(beat.strobes | 1u << (address + n) % 4);
        if (write) beat.lanes[(address + n) % 4] = data[n];
    }
    return burst;
}

}  // namespace tb
