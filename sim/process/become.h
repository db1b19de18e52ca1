// become.h - the child of a fork() that turns into another program
#pragma once

#include <string>
#include <vector>

namespace sim {

// In the child: a process group of its own, which ends with the thread that has forked; these
// descriptors as standard input, and as standard output and error.  Exit code 127: there is no such
// program, or no such folder.
[[noreturn]] void become(const std::vector<std::string>& command, const char* folder, int input,
                         int output);

// An Outcome's code, of what waitpid() has given.
int code_of(int status);

}  // namespace sim
