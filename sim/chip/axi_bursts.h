// axi_bursts.h - what a transaction becomes on the AXI3 bus of a bridge to the FPGA
//
// As the Cortex-A9 makes it:
//
//   memory                       loads                          stores
//   Strongly-ordered, Device     words of 32 bits, up to 16     words of 32 bits, 1 or 2: those of
//                                                               eight aligned bytes
//   Normal                       words of 64 bits, up to 9      words of 64 bits, up to 4: a line
//                                                               of the L2 cache's store buffer
//   one word or less             itself
//
// As the DMA controller makes it: by its channel's control register.  No burst crosses 4 KB.
//
// Then as the bridge makes it fit its width.  What is wider becomes bursts of more words, of at
// most 16 each.  What is narrower is packed where AxCACHE[1] lets it, and else goes as it is.  A
// bus of 64 bits, as wide as the interconnect, changes nothing.
//
// Sources: Cortex-A9 TRM (ARM DDI 0388I), 8.1.2, which lists the bursts, but not which instruction
// makes which; Cyclone V HPS TRM, "Upsizing Data Width Function", "Downsizing Data Width Function";
// L2C-310 TRM (ARM DDI 0246), "Store buffer operation".
//
// Not handled: caches, which would fill and write back whole lines; the L2 cache, which the table
// takes to be on.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/hps/axi_attributes.h"

namespace sim {

struct AxiBurst {
    std::uint32_t address;
    unsigned beats, size;   // a beat's bytes
    bool fixed;             // FIXED, else INCR
    unsigned first, bytes;  // of the transaction, which it carries
};

// `width`: of the bus, in bytes.
std::vector<AxiBurst> axi_bursts(std::uint32_t address, unsigned bytes, bool write,
                                 const AxiAttributes& how, unsigned width);

// The burst of words that carries a transaction from its byte `first` on: of at most 16 words, and
// none beyond 4 KB.  One byte, or one aligned half-word, is narrow.
AxiBurst long_burst(std::uint32_t address, unsigned bytes, unsigned first);

}  // namespace sim
