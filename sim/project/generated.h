// generated.h - the files that are written for each design, beside its cleaned sources.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/project/binding.h"
#include "sim/project/project.h"

namespace sim::project {

// Only if it differs, so that a compiler that looks at times sees what is new.
void write_if_new(const std::filesystem::path& file, const std::string& text);

// The board's own clocks that the design uses, among the PLLs'.  Where nothing but CLOCK_50 tells
// the monitor when to look, a faster clock of the design does: its pixels may be shorter.
void add_board_clocks(const BoardDescription& board, Elaborated& elaborated, Binding& binding);

// de1sim_pll_taps.v: CLOCK_50 and the PLLs' outputs, as inputs of the chip.
std::string tap_text(const Elaborated& elaborated, const Binding& binding);

// de1sim_facts.h: what runtime/model.cpp has to know of the design.
std::string facts_text(const Project& project, const Elaborated& elaborated,
                       const Binding& binding);

// de1sim_loops.h, by Verilator: "Signal unoptimizable: ... 'de1sim_chip.de1sim_design.a'"
// is a loop without a register, which may oscillate.
// Where it names none, `otherwise` is taken.
std::string loops_text(const std::string& output, const std::string& otherwise);

}  // namespace sim::project
