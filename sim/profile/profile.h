// profile.h - where a program's instructions go: by function, and by who called whom.
//
// Follows every instruction.  A function is entered by a call when control comes to another one and
// LR points behind the instruction before; it is left when control comes to a return address that
// is waiting on the list of calls.  Anything else - a tail call, a branch, an exception's entry and
// end - changes the function without a call.  Instructions outside of all functions are in "???".
//
// The processor stops where control may leave a function: 0.1 us each time, which makes a run of
// the demo's hundred shapes 2 % longer.
//
// Not handled: a function that calls itself is counted as one call; MOV LR, PC and a jump are no
// call; source lines.
//
// Format: callgrind profile data, version 1, as the Valgrind manual describes it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/cpu/arm_core.h"
#include "sim/cpu/elf.h"

namespace sim {

class Profile : public ArmTally {
public:
    // `elf` must outlive it.
    explicit Profile(const ElfProgram& elf);

    void ran(const Run& run) override;
    bool same_function(std::uint32_t pc, std::uint32_t other) const override;

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

    // Of the function list; its size is "???".
    struct Place {
        std::size_t function;
        std::uint32_t begin, end;  // addresses around it that are known to be of the same
    };
    Place place_of(std::uint32_t pc) const;
    void change(std::uint32_t pc, std::uint32_t link);
    void leave(Edges& edges, const Call& call) const;
    std::string name(std::size_t function) const;

    const ElfProgram& elf_;
    std::vector<std::uint64_t> own_;  // instructions of each function; the last is "???"
    Edges edges_;
    std::vector<Call> calls_;
    std::uint64_t count_ = 0;
    Place here_;
    std::uint32_t last_end_ = 1;  // behind the instruction before
};

}  // namespace sim
