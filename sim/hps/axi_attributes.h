// axi_attributes.h - what a transaction is on the processor's AXI buses, besides its address and
// its data
//
// A transaction without this extension is the processor's, to Strongly-ordered memory.
#pragma once

#include <cstdint>

#include <tlm>

namespace sim {

struct AxiAttributes : tlm::tlm_extension<AxiAttributes> {
    // AxCACHE as the Cortex-A9 has it for its types of memory, and AxPROT.
    static constexpr unsigned STRONGLY_ORDERED = 0, DEVICE = 1, NORMAL = 3;
    static constexpr unsigned PRIVILEGED = 1;

    enum class Master { PROCESSOR, DMA } master = Master::PROCESSOR;
    unsigned channel = 0;     // of the DMA controller
    unsigned beat_bytes = 0;  // the DMA controller's, 1 to 8
    bool fixed = false;       // each beat at the same address
    unsigned cache = STRONGLY_ORDERED, prot = PRIVILEGED;
    bool exclusive = false;        // LDREX, STREX: AxLOCK 1
    bool exclusive_taken = false;  // the answer: EXOKAY, not OKAY

    tlm::tlm_extension_base* clone() const override { return new AxiAttributes{*this}; }
    void copy_from(const tlm::tlm_extension_base& other) override {
        *this = static_cast<const AxiAttributes&>(other);
    }
    void free() override {}  // the initiator's
};

}  // namespace sim
