// profile.h - where a program's instructions go: by function, and by who called whom.
//
// Follows every instruction.  A function is entered by a call when control comes to another one and
// LR points behind the instruction before; it is left when control comes to a return address that
// is waiting on the list of calls.  Anything else - a tail call, a branch, an exception's entry and
// end - changes the function without a call.  Instructions outside of all functions are in "???".
//
// Costs about 5 ns an instruction, 0.1 us a change of function.
//
// Not handled: a function that calls itself is counted as one call; source lines.
//
// Format: callgrind profile data, version 1, as the Valgrind manual describes it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/hps/arm_core.h"
#include "sim/hps/elf.h"

namespace sim {

class Profile : public ArmProbe {
public:
    // Both must outlive it.
    Profile(const ArmCore& core, const ElfProgram& elf);

    bool before(std::uint32_t pc) override;

    // The file's text.  Calls that are still going on are counted up to here.
    std::string callgrind() const;

private:
    struct Call {
        std::size_t caller, callee;
        std::uint32_t return_to;
        std::uint64_t begin;  // instructions done before it
    };
    struct Edge {
        std::uint64_t calls = 0, instructions = 0;
    };
    using Edges = std::map<std::pair<std::size_t, std::size_t>, Edge>;

    void change(std::uint32_t pc);
    void locate(std::uint32_t pc);
    void leave(Edges& edges, const Call& call) const;
    std::string name(std::size_t function) const;

    const ArmCore& core_;
    const ElfProgram& elf_;
    std::vector<std::uint64_t> own_;  // instructions of each function; the last is "???"
    Edges edges_;
    std::vector<Call> calls_;
    std::uint64_t count_ = 0;
    std::size_t function_;               // the present one
    std::uint32_t begin_ = 1, end_ = 0;  // its addresses, as far as they are known to be its own
    std::uint32_t last_pc_ = 1;
};

}  // namespace sim
