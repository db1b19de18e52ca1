// unsupported.h - what a project may consist of that cannot be simulated, and the message for each.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace sim::project {

// "a schematic; ...", by the file's ending: Qsys systems, schematics, other languages, netlists.
std::optional<std::string> unsupported_file(const std::filesystem::path& file);

// "this part of the processor (HPS) ...", by the name of a module that neither a file defines nor a
// model is of.
std::optional<std::string> unsupported_module(const std::string& name);

// Quartus' own models, by the file's name: altera_mf.v, 220model.v.
bool is_simulation_library(const std::filesystem::path& file);

// Verilog or VHDL that is encrypted; files of IP are.
bool is_encrypted(const std::filesystem::path& file, std::string_view text);
extern const char ENCRYPTED[];

}  // namespace sim::project
