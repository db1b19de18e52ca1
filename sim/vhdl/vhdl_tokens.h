// vhdl_tokens.h - VHDL text as tokens that know their place: those of sim/verilog/tokens.h.
//
// A bit string, x"3F", and a character, '1', are each a STRING; the tick of an attribute is a
// SYMBOL, and so is each of => <= >= := /= ** <> ?=.  Names have the case that the text has.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/verilog/tokens.h"

namespace sim::project {

// `text` must outlive what is returned.  A string or extended name without an end reaches to the
// line's.
Tokens vhdl_tokens(std::string_view text);

// The tokens in lower case, but strings and extended names as they are.
std::vector<std::string> in_lower_case(const std::vector<Token>& tokens);

}  // namespace sim::project
