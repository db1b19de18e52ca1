// edits.h - changes to Verilog text, by the number of the token where they are.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>

#include "sim/verilog/tokens.h"

namespace sim::project {

struct Edits {
    std::map<std::size_t, std::string> before, after;  // text to write there
    std::set<std::size_t> left_out;  // tokens; the white space and comments before them stay
    std::map<std::size_t, std::string> notes;  // for a person, with that token's line
};

// The text of `tokens` with the changes; `notes` are the caller's.
std::string changed_text(const Tokens& tokens, const Edits& edits);

}  // namespace sim::project
