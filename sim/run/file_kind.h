// file_kind.h - what to do with a file that is given as a program or scenario and is neither.
//
// A file is recognised by its first bytes, then by its name: sources of programs and of designs,
// images of memories, bitstreams, projects of Quartus and of Intel's Monitor Program, pictures,
// archives.  What may be a scenario is left to the scenario's reader, which says line and column.
#pragma once

#include <filesystem>

namespace sim {

// Throws std::runtime_error, one line that says what the file is and which command it needs: if it
// is not there, or is certainly no scenario (text) and no ELF file.
void refuse_other_kinds(const std::filesystem::path& scenario_or_program);

// The same for a file that can only be a program; an ELF file passes, whatever is in it.
void refuse_no_program(const std::filesystem::path& program);

}  // namespace sim
