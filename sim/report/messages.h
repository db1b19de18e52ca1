// messages.h - the simulator's messages: lines on stderr, results on stdout.
//
// A message never ends a run: nothing here throws, and a stderr that is closed, full or without a
// reader is ignored.  Texts may contain names from outside; lines are made printable.
#pragma once

#include <string_view>

namespace sim {

// Opens /dev/null on those of the descriptors 0 to 2 that are closed; otherwise a file of the run
// could get their numbers.  Makes a write to a pipe without a reader fail instead of ending the
// program.  To be called before anything is opened.
void prepare_standard_streams() noexcept;

// One line on stderr, control characters in it as \xNN.
void message(std::string_view line) noexcept;

// The same with "de1sim: " in front.
void complain(std::string_view line) noexcept;

// To stderr as it is, for a terminal's control sequences.
void draw(std::string_view text) noexcept;

// To stdout as it is.  False, with a line on stderr, if it could not be written completely.
[[nodiscard]] bool print_result(std::string_view text) noexcept;

}  // namespace sim
