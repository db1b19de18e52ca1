// formats.h - the two formats of memory_image.h; `name` is the file's, for messages.
#pragma once

#include <string>
#include <string_view>

#include "sim/project/memory_image.h"

namespace sim::project {

void read_mif(std::string_view text, const std::string& name, MemoryImage& image);
void read_intel_hex(std::string_view text, const std::string& name, MemoryImage& image);

}  // namespace sim::project
