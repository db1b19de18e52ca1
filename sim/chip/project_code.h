// project_code.h - a program in the design's own memory, behind one of the processor's bridges
//
// The parts of its ELF that are linked there are written by the bridge before the program begins,
// word by word as a debugger does it, and read back.  Instructions are fetched from a copy, as from
// the processor's instruction cache, without time on the bridge; loads and stores go to the design.
// What is written by a bridge is in the copy, too.
//
// Not handled: what something in the design writes to that memory: the copy does not change.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/cpu/elf.h"
#include "sim/hps/bus.h"

#include <tlm>

namespace sim {

class ProjectCode {
public:
    // `has_place`: that something is at an address of a bridge.  std::runtime_error: a part of the
    // program is linked to where nothing is.
    ProjectCode(const ElfProgram& program, const std::function<bool(std::uint32_t)>& has_place);

    bool is_empty() const { return pages_.empty(); }
    // To be called by a process that may wait.  Returns what is wrong: the design does not keep it.
    std::string load(Bus& bus) const;

    // Direct access to the copy, for a bridge's window: `tx` has the address in it.
    bool direct(std::uint32_t window, const tlm::tlm_generic_payload& tx, tlm::tlm_dmi& dmi);
    // Returns whether it is in the copy.
    bool written(std::uint32_t address, const std::uint8_t* data, unsigned bytes);

private:
    struct Pages {
        std::uint32_t base;
        std::vector<std::uint8_t> bytes;
    };
    std::vector<ElfSegment> segments_;  // those in the design, rising
    std::vector<Pages> pages_;          // rising, apart from each other
};

}  // namespace sim
