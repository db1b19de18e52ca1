// shell_word.h - a word as a shell needs it, in commands that people copy and scripts that run
#pragma once

#include <string>

namespace sim {

// The word itself if no shell sees more in it than one word, or the word in quotation marks.
std::string shell_word(const std::string& word);

}  // namespace sim
