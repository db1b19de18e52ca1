#include "sim/verilog/project_error.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

namespace sim::project {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    constexpr std::uintmax_t MOST = 64u << 20;
    std::error_code error;
    if (fs::is_directory(file, error))
        throw ProjectError{file.string() + ": is a folder, expected a file"};
    const auto size = fs::file_size(file, error);
    if (!error && size > MOST)
        throw ProjectError{file.string() + ": larger than 64 MB, expected a source file"};
    std::ifstream in{file, std::ios::binary};
    if (!in) throw ProjectError{file.string() + ": " + std::strerror(errno)};
    std::ostringstream text;
    text << in.rdbuf();  // at once, not character by character
    return text.str();
}

}  // namespace sim::project
