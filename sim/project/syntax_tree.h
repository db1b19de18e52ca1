// syntax_tree.h - Verilator's tree of a design, from the file that it writes.
#pragma once

#include <filesystem>
#include <string>

#include <pugixml.hpp>

namespace sim::project {

// The XML of `verilator --xml-only`, or the JSON of `verilator --json-only` in the form of that
// XML; Verilator 5.048 has the JSON alone.  Beside the JSON is its tree_meta().  ProjectError: the
// file is not whole.
pugi::xml_document syntax_tree(const std::filesystem::path& file);

// The file that Verilator writes beside the JSON `file`, with the names of the sources.
std::string tree_meta(const std::string& file);

}  // namespace sim::project
