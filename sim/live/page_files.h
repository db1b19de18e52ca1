// page_files.h - the files of the page, which are parts of the program.
#pragma once

#include <string_view>

namespace sim::live {

struct PageFile {
    std::string_view name, type, bytes;
};

// Null if there is no such file; "" is index.html.
const PageFile* page_file(std::string_view name);

}  // namespace sim::live
