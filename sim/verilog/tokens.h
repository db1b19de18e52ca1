// tokens.h - Verilog text as tokens that know their place, so that text can be changed around them.
//
// Comments, white space and lines of the preprocessor are no tokens, but what lies between two
// tokens is kept: joining gap and text of all of them, and the tail, gives the file back.
// Nothing is preprocessed: both branches of an `ifdef are there.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sim::project {

struct Token {
    enum class Kind { NAME, NUMBER, STRING, SYMBOL, MACRO };
    Kind kind;
    std::string_view text;  // NUMBER: with size and base, as in 4'b0101 or 8 'hFF
    std::string_view gap;   // what lies before it
    unsigned line;          // from 1
    bool is(std::string_view other) const { return text == other; }
};

struct Tokens {
    std::vector<Token> all;
    std::string_view tail;  // after the last one
};

// `text` must outlive what is returned.  A comment or string without an end reaches to the file's.
Tokens tokens_of(std::string_view text);

// The tokens [begin, end) in one line: a blank wherever something lies between two.
std::string text_between(const std::vector<Token>& tokens, std::size_t begin, std::size_t end);

// Counts in `open` the conditions (`ifdef) that a gap opens and closes.  What stands in a branch of
// one may not be read.
void follow_conditions(std::string_view gap, unsigned& open);

// A keyword of Verilog-2005: no name of a module or an instance.
bool is_keyword(std::string_view name);

}  // namespace sim::project
