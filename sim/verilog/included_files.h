// included_files.h - the files that a project's Verilog includes.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sim::project {

struct IncludedFile {
    std::string name;  // as the directive has it
    std::filesystem::path path;
    std::string text;
    // What Quartus reads of it, see synthesised.h.
    std::string synthesised;
};

// Those that `texts` include, and those that these include in turn, each once.  A name is looked
// for in `folders`, in that order; one that is not found, or is a macro, is passed over.
std::vector<IncludedFile> included_files(const std::vector<std::string>& texts,
                                         const std::vector<std::filesystem::path>& folders,
                                         const std::vector<std::string>& macros);

}  // namespace sim::project
