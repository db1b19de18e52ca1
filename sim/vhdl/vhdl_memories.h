// vhdl_memories.h - memories that begin with a file: Quartus' attribute ram_init_file.
//
//   type words is array (0 to 255) of std_logic_vector(7 downto 0);
//   signal m : words;                                 signal m : words := (0 => "00010010", ...
//   attribute ram_init_file : string;
//   attribute ram_init_file of m : signal is "m.mif";
//
// Not handled: a file that a generic names; words of other types than vectors of bits; a word whose
// bits are not numbers in the text, where the file is Intel HEX.  Such memories begin with zeros.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace sim::project {

// The words of a file as bits, 0101; none: it is nowhere.  `line` names the attribute's; `width`
// is that of the memory's words, or 0 if it is not known.
using InitialWords =
    std::function<std::vector<std::string>(const std::string& file, unsigned line, unsigned width)>;

// Lines are kept.
std::string with_initial_words(const std::string& text, const InitialWords& words);

}  // namespace sim::project
