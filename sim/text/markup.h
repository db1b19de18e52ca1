// markup.h - text as XML and HTML have it
#pragma once

#include <string>
#include <string_view>

namespace sim {

// For text and for attributes in quotes.  Control characters, which neither can represent, are
// \xNN; so is all that no terminal should get.
std::string escape_markup(std::string_view text);
// The same, but that the ends of lines stay.
std::string escape_lines(std::string_view text);

}  // namespace sim
