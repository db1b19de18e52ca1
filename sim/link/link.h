// link.h - `de1sim link`: kernel modules, and the program that uses them, for the emulated Linux
//
// A C file that includes a header of the kernel's, such as <linux/module.h>, is a module and is
// compiled against sw/kmod/kmod.h; the others are the program.  The modules become an ELF file of
// their own, NAME.ko, with sw/kmod and with the devices of the project's Platform Designer system.
// A program carries it in a section: the emulated kernel loads it before the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/run/project_commands.h"

namespace CLI {
class App;
}

namespace sim {

struct LinkOptions {
    std::vector<std::filesystem::path> files;  // .c, .cpp, .S, .o, .a
    ProjectOptions project;
    std::filesystem::path out;           // empty: program.elf, or MODULE.ko
    std::vector<std::string> arguments;  // of the compiler: -lm, -I include, -O2
};

void add_link_options(CLI::App& command, LinkOptions& options);

// Returns an exit code.  What the compiler says of the files is on stderr.  ProjectError: the
// project cannot be read, has no system with a processor; there is no compiler; a function of the
// kernel is missing in kmod.h, with the place.
int link_program(const LinkOptions& options);

}  // namespace sim
