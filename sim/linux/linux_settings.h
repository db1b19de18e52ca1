// linux_settings.h - what a Linux program is started with
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/cpu/elf.h"
#include "sim/linux/host_sockets.h"

namespace sim {

struct LinuxSettings {
    struct Module {
        ElfProgram elf;
        std::vector<std::string> parameters;  // "period=5"
    };

    std::filesystem::path root;          // the program's /; empty: it has no files
    std::vector<std::string> arguments;  // after the program's name
    std::filesystem::path input;         // standard input; empty: the console
    std::vector<Module> modules;         // loaded before it
    std::vector<NamedPeer> network;      // outside, that it reaches
};

}  // namespace sim
