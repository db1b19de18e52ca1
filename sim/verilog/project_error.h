// project_error.h - how a file of a project is refused, and how one is read
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace sim::project {

// What is wrong with a project, in a line: file, line, what, what was expected.
class ProjectError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
    std::vector<std::string>
        notes;  // what was found out before, which may be the cause; a line each
};

// The file's text.  ProjectError: it cannot be read, or is larger than 64 MB.
std::string text_of(const std::filesystem::path& file);

}  // namespace sim::project
