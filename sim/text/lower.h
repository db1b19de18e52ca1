// lower.h - ASCII text in lower case
#pragma once

#include <algorithm>
#include <string>

namespace sim {

inline std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

}  // namespace sim
