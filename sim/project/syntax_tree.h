// syntax_tree.h - Verilator's tree of a design, from the file that it writes.
#pragma once

#include <filesystem>
#include <string>

#include <pugixml.hpp>

namespace sim::project {

// The XML of `verilator --xml-only`, or the JSON of `verilator --json-only` (from 5.022 on, which
// alone is left in 5.042) as such XML, with its tree_meta() beside it: files, modules, variables,
// instances, types, and the places of the statements that are nodes of their own.  ProjectError.
pugi::xml_document syntax_tree(const std::filesystem::path& file);

// The file that Verilator writes beside the JSON `file`, with the names of the sources.
std::string tree_meta(const std::string& file);

}  // namespace sim::project
