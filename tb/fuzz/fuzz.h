// fuzz.h - targets of make fuzz: each takes any bytes and aborts where a promise does not hold.
//
// A target NAME is try_NAME() in NAME/, with its seeds in NAME/seeds.  The sanitizers that make
// fuzz builds with find the rest.  What a target refuses is thrown as the library's own type of
// error; any other exception ends the program.
#pragma once

#include <string>
#include <string_view>

namespace fuzz {

// Prints `promise` and aborts unless it holds.
void must(bool holds, const char* promise);

// The message of a refusal: a line, printable, not empty.
void must_be_a_line(const std::string& message);

// The path of a file in memory with these bytes, up to the next call, for what reads by path.
std::string path_in_memory(std::string_view bytes);

// Cuts the bytes up to the next end of line, or all, off `rest`.
std::string_view next_line(std::string_view& rest);
// Cuts a byte off; 0 at the end.
unsigned char next_byte(std::string_view& rest);

#define TARGET(NAME) void try_##NAME(std::string_view input);
#include "targets.def"
#undef TARGET

}  // namespace fuzz
