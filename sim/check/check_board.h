// check_board.h - `de1sim check-board` and `de1sim compare`: is the board what was simulated?
//
//   de1sim check-board ---> out/check-board/report.json --.
//                                                          +--> de1sim compare A B
//   board: collide-linux --self-test=report.json ---------'
#pragma once

#include <filesystem>

#include "sim/run/options.h"
#include "sim/run/run.h"

namespace sim {

// --out, --elf, --quiet.  Sets `options` to a run of selftest::run(), or of an ELF that takes
// --self-test, with the scenario check_board.yaml in the person's place.
void add_check_board_options(CLI::App& command, RunOptions& options);

// Prints what differs, or that nothing does.  Returns PASSED, FAILED if the reports differ, or
// WRONG_INPUT, with a line on stderr, if one cannot be read or has no checks.
ExitCode compare_reports(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace sim
