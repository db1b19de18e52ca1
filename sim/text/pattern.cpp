// pattern.cpp - see pattern.h
#include "sim/text/pattern.h"

#include <stdexcept>

namespace sim {

Pattern::Pattern(const std::string& expression) {
    if (regcomp(&compiled_, ("^(" + expression + ")$").c_str(), REG_EXTENDED) != 0)
        throw std::logic_error{"not a regular expression: " + expression};
}

bool Pattern::matches(const std::string& text) const {
    // With its length, since a text of a YAML file may have a NUL within.
    regmatch_t whole{0, static_cast<regoff_t>(text.size())};
    return regexec(&compiled_, text.data(), 1, &whole, REG_STARTEND) == 0;
}

}  // namespace sim
