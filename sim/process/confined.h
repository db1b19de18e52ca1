// confined.h - commands of strangers: without network, and with the files that they need alone
//
// bwrap (bubblewrap) makes namespaces of the kernel for a command: there are /usr, an empty /tmp,
// the folders that are named here, and no other process.  prlimit bounds its memory and its files.
//
// Not handled: the processor time, which the caller's time limit bounds; the number of processes of
// root, who has no such limit.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace sim {

struct Confinement {
    std::vector<std::filesystem::path> readable;  // folders; those of `hidden` in them are empty
    std::vector<std::filesystem::path> hidden;
    std::vector<std::filesystem::path> writable;  // folders, which exist
    std::filesystem::path cache;                  // $XDG_CACHE_HOME/de1sim, read-only; or empty
    std::uint64_t memory_bytes = 0;               // of a process, for its data
    std::uint64_t file_bytes = 0;                 // of a file that it writes
};

// The command that runs `command` in that confinement, in the same working directory and with the
// same names.
std::vector<std::string> confined(const std::vector<std::string>& command,
                                  const Confinement& confinement);

// std::runtime_error: bwrap is missing, or the kernel does not let this user make namespaces.
void check_confinement();

}  // namespace sim
