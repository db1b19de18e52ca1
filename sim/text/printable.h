// printable.h - text from outside, made safe for terminals, logs and XML
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace sim {

// The UTF-8 character that begins at `at`, which moves past it; nothing and one byte if it is not
// valid UTF-8.  Surrogates, overlong forms and values above U+10FFFF are not valid.
std::optional<char32_t> next_utf8(std::string_view text, std::size_t& at);

bool is_utf8(std::string_view text);

// Valid UTF-8 in which each byte of a control character, of a Unicode noncharacter, of a mark that
// reorders text, or of invalid UTF-8 is written \xNN.
std::string printable(std::string_view text);

}  // namespace sim
