// lost_accesses.h - accesses that the FPGA answers and that come to nothing, each said once
//
// A write is lost, and a read gives 0, in the half of the on-chip memory's window behind its 256 KB
// and in a block of registers where the map has none.  A write to a read-only register is lost.
//
// Programs clear too far, or use a register that another system has, and mostly no harm comes of
// it.  So such an access ends nothing; but what it was meant for is not there, so it is told.
//
// On the board the interconnect gives what no slave owns to the one with the largest address span,
// which on the full bridge is the SDRAM (Intel, Platform Designer User Guide, Accessing Undefined
// Memory Regions; support article 000086447).
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

    // Of an access that was answered, what a person should know; the first time that a program
    // writes, or reads, in vain at this block or memory.
    std::optional<std::string> look(std::uint32_t address, unsigned bytes, bool write);

private:
    enum Word : std::uint8_t { READ_WRITE, READ_ONLY, NOTHING };
    std::optional<std::string> say(std::uint32_t address, bool write, Word word);

    std::vector<Word> words_;  // of the lightweight bridge
    std::set<std::pair<std::uint32_t, bool>> said_;
};

}  // namespace sim
