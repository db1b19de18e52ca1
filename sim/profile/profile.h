// profile.h - where a program's instructions go: by function, and by who called whom.
//
// Follows every instruction.  It is a call when control reaches another function and LR (ra) points
// after the previous instruction.  It is a return when control reaches a return address on the list
// of open calls.  Anything else (a tail call, a branch, the entry and end of an exception) changes
// the function without a call.  Libraries that the dynamic linker has loaded and kernel modules are
// objects of their own; what has no name in one has the object's.  Instructions elsewhere are in
// "???".
//
// The ARM stops wherever control may leave a function.  That costs 0.1 us each time, 2 % of a run
// of the demo with a hundred shapes.  Of Nios V see nios_v_profile.h.
//
// Not handled: recursion is counted as one call; MOV LR, PC and a jump, or a JAL that writes t0,
// are not recognised as a call; source lines.
//
// Format: callgrind profile data, version 1, as the Valgrind manual describes it.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sim/cpu/arm_core.h"
#include "sim/cpu/elf.h"

namespace sim {

class Profile final : public ArmTally {
public:
    // `elf` must outlive it.
    explicit Profile(const ElfProgram& elf);

    void ran(const Run& run) override;
    // In the function of what ran last.
    bool is_here(std::uint32_t pc) const { return pc - here_.begin < here_.end - here_.begin; }
    bool same_function(std::uint32_t pc, std::uint32_t other) const override;

    // At each call, once it has been made: how many are open, and the numbers of its functions.
    std::function<void(std::size_t depth, std::size_t caller, std::size_t callee)> on_call =
        [](std::size_t, std::size_t, std::size_t) {};
    std::string name(std::size_t function) const;
    const ElfProgram& program() const { return elf_; }

    struct Place {
        std::size_t function;
        std::uint32_t begin, end;  // addresses around it known to be in the same function
    };

    // The file's text.  Calls that are still open are counted up to now.
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

    const ElfProgram& object(std::size_t i) const;  // 0: the program; the libraries
    Place place_of(std::uint32_t pc) const;
    // Which has it; the number becomes that of its own list, whose size is all that has no name.
    std::size_t object_of(std::size_t& function) const;
    std::string source_of(std::size_t object) const;
    std::string name_in(std::size_t object, std::size_t function) const;
    void change(std::uint32_t pc, std::uint32_t link);
    void leave(Edges& edges, const Call& call) const;

    const ElfProgram& elf_;
    std::vector<std::uint64_t> own_;  // instructions of each function, of "???" and of libraries
    Edges edges_;
    std::vector<Call> calls_;
    std::uint64_t count_ = 0;
    Place here_;
    std::uint32_t last_end_ = 1;  // address after the previous instruction
};

}  // namespace sim
