// messages.h - the simulator's messages: lines on stderr, results on stdout, and what the simulated
// program prints, also on stdout.
//
// Where both streams are one terminal, file or pipe, a message begins a line of its own.
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

// A line on a terminal that shows how far something is: the next one, a message or what a program
// prints takes its place.  Not shown while a program has printed the beginning of a line there.
void show_status(std::string_view text) noexcept;
void clear_status() noexcept;

// What a program prints, to stdout as it is.  After a failure to write nothing more is written.
void print_output(std::string_view text) noexcept;

// To stdout as it is, on a line of its own.  False, with a line on stderr, if it could not be
// written completely.
[[nodiscard]] bool print_result(std::string_view text) noexcept;

}  // namespace sim
