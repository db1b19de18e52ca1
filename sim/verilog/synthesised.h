// synthesised.h - the part of a Verilog file that Quartus reads: what is for simulators goes.
//
//   // synthesis translate_off          up to translate_on nothing is read, no directive either;
//   initial $monitor(q);                "synopsys", "pragma" and so on are words for it, too, and
//   // synthesis translate_on           a comment /* of this kind */ does the same, and so do
//                                       synthesis_off and synthesis_on
//
//   // synthesis read_comments_as_HDL on     up to "off" the comments are read
//
// A comment in a branch of an `ifdef that is not taken says nothing: the wizards' files have
// translate_off in one, where ALTERA_RESERVED_QIS, which Quartus defines, is not defined.
//
//   `define FF(q, rst) /``* synopsys sync_set_reset `"rst`" *``/ ...      is no comment here
//
// Not handled: conditions on macros that an included file defines; orders that are on where a file
// includes another.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sim::project {

// The text with blanks in the place of what is not read; lines and columns stay.
// `macros`: NAME or NAME=VALUE.
std::string as_synthesised(std::string_view text, const std::vector<std::string>& macros = {});

// What a comment orders: "translate_off", "read_comments_as_hdl on"; empty: nothing.
std::string order_in(std::string_view comment);

}  // namespace sim::project
