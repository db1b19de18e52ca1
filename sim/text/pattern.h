// pattern.h - a regular expression, POSIX's extended: <regex> would take seconds to compile
#pragma once

#include <regex.h>

#include <string>

namespace sim {

class Pattern {
public:
    explicit Pattern(const std::string& expression);
    ~Pattern() { regfree(&compiled_); }
    Pattern(const Pattern&) = delete;
    Pattern& operator=(const Pattern&) = delete;

    bool matches(const std::string& text) const;  // the whole text

private:
    regex_t compiled_;
};

}  // namespace sim
