// vhdl_dialect.h - VHDL as Quartus reads it, written as GHDL takes it, which reads VHDL-2008.
//
//   -- altera translate_off              up to translate_on nothing is read, by each word that
//                                        Quartus knows: synthesis, pragma, exemplar ...
//   -- synthesis read_comments_as_HDL on     up to "off" the comments are read
//   signal release, force : std_logic;   words of VHDL-2008 are names in VHDL-1993
//   wait until clk = '1';                waits for an edge: clk'event and clk = '1'
//
// Lines are kept.
#pragma once

#include <string>

namespace sim::project {

std::string as_ghdl_takes_it(const std::string& text);

// The name that GHDL has for `name`, and text with such names as it was before.
std::string name_for_ghdl(const std::string& name);
std::string with_own_names(std::string text);

}  // namespace sim::project
