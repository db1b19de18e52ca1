// project_masters.h - the processor's memory and peripherals, for masters in a project's design
//
// fpga2sdram reaches the DDR3; fpga2hps the DDR3 (from 0 on, and by the window of the coherent
// accesses from 0x80000000 on), the peripherals and the on-chip RAM.
//
// All ports share the DDR3's bandwidth, and are served as they come: a burst takes its bytes' time
// after those before it, and what is read is there LATENCY later.  The processor's own accesses
// take nothing of it.
//
// Memory is as the processor sees it: the simulation has no caches.  On the board the processor's
// caches hide what a master writes by fpga2sdram, or by fpga2hps below 0x80000000, and a master
// there reads what has not been cleaned yet.
//
// Sources: Cyclone V HPS TRM, "HPS Address Spaces", "SDRAM Controller Subsystem".
#pragma once

#include <cstdint>

#include "sim/chip/processor_system.h"
#include "sim/project/model.h"

namespace sim {

class ProjectMasters final : public project::ProcessorMemory {
public:
    static constexpr std::uint64_t LATENCY_PS = 250'000;

    // `ddr3_mb_per_s`: the bandwidth of all ports together, from 1 on.
    ProjectMasters(ProcessorSystem& system, unsigned ddr3_mb_per_s)
        : system_{system}, byte_fs_{1'000'000'000 / ddr3_mb_per_s} {}

    bool is_open(unsigned port) const override;
    bool takes(unsigned port, std::uint64_t now_ps) const override;
    std::uint64_t begin(unsigned bytes, std::uint64_t now_ps) override;
    Answer access(unsigned port, bool write, std::uint32_t address, std::uint8_t* data,
                  unsigned bytes, std::uint64_t now_ps) override;

private:
    ProcessorSystem& system_;
    const std::uint64_t byte_fs_;
    std::uint64_t busy_until_ps_ = 0;
};

}  // namespace sim
