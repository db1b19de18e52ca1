// check_board.h - `de1sim check-board` and `de1sim compare`: is the board what was simulated?
//
//   de1sim check-board ---> out/check-board/report.json --.
//                                                          +--> de1sim compare A B
//   board: collide-linux --self-test=report.json ---------'
#pragma once

#include <filesystem>

#include "sim/report/exit_code.h"
#include "sim/run/description.h"

namespace CLI {
class App;
}

namespace sim {

// --out, --elf, --quiet.  Sets `run` to one of selftest::run(), or of an ELF that takes
// --self-test, with the scenario check_board.yaml in the person's place.
void add_check_board_options(CLI::App& command, RunDescription& run);

// Prints what differs, or that nothing does.  Returns PASSED, FAILED if the reports differ, or
// WRONG_INPUT, with a line on stderr, if one cannot be read or has no checks.
ExitCode compare_reports(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace sim
