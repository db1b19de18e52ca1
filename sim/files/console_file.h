// console_file.h - console.txt: all that was printed, or its beginning and its end
//
// The first FIRST bytes are kept and the last LAST; what is between them is left out, and a line
// says how much that was.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "sim/files/whole_file.h"

namespace sim {

class ConsoleFile {
public:
    static constexpr std::size_t FIRST = 1 << 20, LAST = 1 << 16;

    explicit ConsoleFile(std::filesystem::path path) : file_{std::move(path)} {}

    void print(char character);  // IoError
    void commit();               // IoError

private:
    WholeFile file_;
    std::uint64_t printed_ = 0;
    std::string first_;  // not written yet
    std::string last_;   // a ring once it is full
};

}  // namespace sim
