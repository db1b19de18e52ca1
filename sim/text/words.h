// words.h - the wording of error messages: "expected ..., got ... (did you mean "press"?)"
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sim {

// The candidate that differs in the fewest letters, if it is close enough to be a typing mistake;
// else "".
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

// ` (did you mean "press"?)`, or "" when no candidate is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

// "a, b or c".
std::string list_of(const std::vector<std::string>& words);

// Text from a file in double quotes, printable and at most some 60 characters long.
std::string in_quotes(std::string_view text);

}  // namespace sim
