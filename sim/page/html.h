// html.h - text and pictures as HTML has them
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/text/markup.h"

namespace sim::page {

inline std::string escape(std::string_view text) { return escape_markup(text); }

// In one line.
std::string base64(std::string_view bytes);

// "data:image/png;base64,..."
std::string data_url(const std::vector<std::uint8_t>& png);

}  // namespace sim::page
