// clean_sources.h - a project's sources as Verilator takes them: cleaned copies, VHDL as Verilog.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "sim/project/elaborated.h"
#include "sim/project/project.h"
#include "sim/project/tools.h"
#include "sim/verilog/inout_fits.h"
#include "sim/verilog/quartus/text_checks.h"
#include "sim/vhdl/vhdl_generics.h"

namespace sim::project {

// For each of the project's entities that Verilog wants.
std::vector<GenericEntity> generic_entities(const Project& project);

struct SourceRequest {
    const Project& project;
    const std::vector<GenericEntity>& entities;  // with the sets of generics that are known so far
    const std::function<bool(const std::string& module)>& is_model;
    const std::filesystem::path& folder;  // to write to
    const TimeLimit& limit;
    const std::map<std::string, std::vector<InoutFit>>& inout_fits;  // by file
};

struct CleanSources {
    std::vector<std::filesystem::path> files;  // as seen from the folder
    std::vector<std::string> changes;          // a line each, for a person
    std::vector<InitFile> init_files;          // that the sources name
    std::map<std::string, TextChecks> checks;  // by the name of the file
    std::string included;                      // the texts of all files that they include
};

// Writes folder/source/*, and folder/included/* where Quartus does not read the whole of an
// included file; files there that are the same stay as they are.  ProjectError: GHDL refuses the
// VHDL.
CleanSources clean_sources(const SourceRequest& from);

}  // namespace sim::project
