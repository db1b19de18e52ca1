// html.h - text and bytes as HTML has them
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sim::page {

// For text and for attributes in double quotes; what no terminal should get is \xNN.
std::string escape(std::string_view text);

// "data:image/png;base64,..."
std::string data_url(const std::vector<std::uint8_t>& png);

}  // namespace sim::page
