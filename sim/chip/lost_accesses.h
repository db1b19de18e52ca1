// lost_accesses.h - accesses that the FPGA answers but that have no effect; each is reported once
//
// A write is lost, and a read gives 0, in the second half of the on-chip memory's window (after its
// 256 KB), and in a block at an offset without a register.  A write to a read-only register is
// lost.
//
// Programs clear too far, or use a register of another system, mostly without harm.  So such an
// access does not end the run; but it does not do what the program meant, so it is reported.
//
// On the board the interconnect routes an address that no slave owns to the slave with the largest
// span, which on the full bridge is the SDRAM (Intel, Platform Designer User Guide, Accessing
// Undefined Memory Regions; support article 000086447).
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sim {

class LostAccesses {
public:
    LostAccesses();

    // A message about an access that was answered but lost.  Only for the first write, and the
    // first read, in each block or memory.
    std::optional<std::string> look(std::uint32_t address, unsigned bytes, bool write);

private:
    enum Word : std::uint8_t { READ_WRITE, READ_ONLY, NOTHING };
    std::optional<std::string> say(std::uint32_t address, bool write, Word word);

    std::vector<Word> words_;  // of the lightweight bridge
    std::set<std::pair<std::uint32_t, bool>> said_;
};

}  // namespace sim
