// compiled_headers.h - Verilator's headers, which the compiler reads once and not at each build.
//
// Reading them takes most of the time of compiling a small design.  Precompiled they lie in the
// user's cache, and are made again when the compiler, its options or one of the headers is another.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/project/tools.h"

namespace sim::project {

// $XDG_CACHE_HOME/de1sim, or what stands for it; empty: the user has no folder.
std::filesystem::path user_cache();

// The arguments to add to a command of `compiler`; none where the headers cannot be precompiled.
std::vector<std::string> compiled_headers(const std::vector<std::string>& compiler,
                                          const TimeLimit& limit);

// A command with these arguments has failed: they are made again before the next one.
void forget_compiled_headers(const std::vector<std::string>& command);

}  // namespace sim::project
