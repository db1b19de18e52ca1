// instances.h - what the instances of a module are connected with, as the text has it.
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sim/verilog/source.h"
#include "sim/verilog/tokens.h"

namespace sim::project {

using Modules = std::map<std::string, ModuleText, std::less<>>;

// The first of `ends` from token `i` on that is in no parentheses of any kind, or the file's end.
std::size_t find_outside(const std::vector<Token>& tokens, std::size_t i,
                         std::initializer_list<std::string_view> ends);

// Whether token `i` comes after a module's name, or its parameters, and so is no module's itself.
bool is_instance_name(const std::vector<Token>& tokens, std::size_t i);

struct ConnectionText {
    std::string port;         // empty: there is no such port
    std::size_t first, last;  // the tokens [first, last), one or more
};

// Of all instances in the statement that begins with the name of `module` at token `at`; none if
// that is the name of an instance.
std::vector<ConnectionText> connections_of(const std::vector<Token>& tokens, std::size_t at,
                                           const ModuleText& module);

}  // namespace sim::project
