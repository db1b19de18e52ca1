// init_file.h - where a memory's initial words are, and how they come into the Verilog.
//
// The name is what the project's author wrote for his machine: "../x.mif", ".\font.mif",
// "C:/work/image.hex".  Backslashes are slashes.  It is looked for, in this order:
//   1. as it is, from the project's folder;
//   2. as it is, from the folders of the sources, in the order given;
//   3. by its last part anywhere below the project's folder: the first by path, in its own case
//      before any other.
//
// The memories of rtl/ip ask through DPI (rtl/ip/de1sim_init.vh) while the model's `initial`
// blocks run, that is in its first eval().  Before, set_init_folders() must say where; without it
// the project's folder is the current one.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace sim::project {

struct InitFolders {
    std::filesystem::path project;
    std::vector<std::filesystem::path> sources;
};

std::optional<std::filesystem::path> find_init_file(std::string name, const InitFolders& folders);

// A file that is nowhere leaves a memory of zeros, as with Quartus; `missing` gets the message.
// Without `missing`, and for a file that is broken, the model's eval() throws std::runtime_error.
// Holds for all models of the process: a DPI function has no other context.
void set_init_folders(InitFolders folders, std::function<void(const std::string&)> missing = {});

}  // namespace sim::project
