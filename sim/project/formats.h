// formats.h - the two formats of memory_image.h; `name` is the file's, for messages.
#pragma once

#include <string>
#include <string_view>

#include "sim/project/memory_image.h"

namespace sim::project {

void read_mif(std::string_view text, const std::string& name, MemoryImage& image);
struct MifSize {
    unsigned width;
    std::size_t depth;
};
MifSize size_of_mif(std::string_view text, const std::string& name);
void read_intel_hex(std::string_view text, const std::string& name, MemoryImage& image);

}  // namespace sim::project
