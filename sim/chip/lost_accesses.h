// lost_accesses.h - accesses that the FPGA answers, but not as the program meant; each is reported
// once
//
// In a block at an offset without a register a write is lost, and a read gives 0.  A write to a
// read-only register is lost.  An address that no block or memory has, and a write to a block that
// can only be read, goes where the interconnect sends it (rtl/bus/lw_decode.v, h2f_bridge.v), and
// above the decoded bits addresses repeat: here as on the board.
//
// Programs clear too far, or use a register of another system, mostly without harm.  So such an
// access does not end the run; but it does not do what the program meant, so it is reported.
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
    // `memory_base`: where the processor sees the SDRAM, and the other memories behind it.
    // `has_jp2`: whether there is the parallel port JP2.
    explicit LostAccesses(std::uint32_t memory_base, bool has_jp2 = true);

    // A message about an access that was answered but went astray.  Only for the first write, and
    // the first read, in each block, gap or repetition.
    std::optional<std::string> look(std::uint32_t address, unsigned bytes, bool write);

private:
    enum Word : std::uint8_t { READ_WRITE, READ_ONLY, NOTHING, READ_ALONE, NOBODY };
    std::optional<std::string> registers(std::uint32_t address, bool write, Word word);
    std::optional<std::string> memory(std::uint32_t address, bool write);
    bool is_new(std::uint32_t place, bool write) { return reported_.insert({place, write}).second; }

    const std::uint32_t memory_base_;
    std::vector<Word> words_;  // of the lightweight bridge, as far as it is decoded
    std::set<std::pair<std::uint32_t, bool>> reported_;
};

}  // namespace sim
