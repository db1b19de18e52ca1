// yaml_tree.h - the small part of YAML that scenario files use, with the place of everything
//
// One document of scalars, lists and maps with plain keys.  Refused, because each has hidden
// surprises: anchors and aliases, tags, a key twice in one map, more than 16 levels.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sim {

struct YamlNode {
    enum class Kind { NOTHING, SCALAR, LIST, MAP };

    Kind kind = Kind::NOTHING;
    int line = 0;  // from 1
    int column = 0;
    bool quoted = false;          // or a block scalar: certainly text
    std::string text;             // of a scalar
    std::vector<YamlNode> keys;   // of a map, scalars; keys[i] belongs to items[i]
    std::vector<YamlNode> items;  // of a list or map
};

// True for a scalar that every YAML reader takes as text.  Unquoted 42, 1.5, 0x1F, 007, true, no
// and the like are not.
bool is_text(const YamlNode& node);

// The node in a few words for a message: nothing, a list, a map, 42, "text".
std::string describe(const YamlNode& node);

// Why a file is refused, and where; reader.cpp adds the file's name.
struct Refusal {
    int line;
    int column;
    std::string message;
};

[[noreturn]] void refuse(const YamlNode& at, const std::string& expected, const std::string& got);

// Throws Refusal.  An empty text is a node of kind NOTHING.
YamlNode parse_yaml(std::string_view text);

}  // namespace sim
