// yaml_tree.cpp - builds the tree from yaml-cpp's events, and stops at the first error
//
// It uses events and not yaml-cpp's own tree, which keeps the last of two equal keys, follows
// aliases, and descends to any depth before the caller can refuse the file.
#include "sim/scenario/yaml_tree.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "sim/text/printable.h"
#include "sim/text/words.h"

namespace sim {

namespace {

constexpr std::size_t MAX_LEVELS = 16;

// yaml-cpp's text in UTF-8: it makes the single bytes 0x85 and 0xA0 of the escapes \N and \_, which
// stand for U+0085 and U+00A0.
std::string in_utf8(std::string_view text) {
    std::string all;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t begin = at;
        const bool valid = next_utf8(text, at).has_value();
        if (!valid) all += '\xC2';
        all += text.substr(begin, at - begin);
    }
    return all;
}

bool is_all(std::string_view text, const char* characters) {
    return !text.empty() && text.find_first_not_of(characters) == text.npos;
}

std::string_view without_sign(std::string_view text) {
    return text.substr(!text.empty() && (text[0] == '-' || text[0] == '+'));
}

// What YAML 1.1 or 1.2 takes as a number: 42, -1.5e3, .5, 007, 0x1F, 1_000, 12:30.
bool is_number(std::string_view text) {
    text = without_sign(text);
    if (text.size() > 2 && text[0] == '0' && is_all(text.substr(1, 1), "xXoObB"))
        return is_all(text.substr(2), "0123456789abcdefABCDEF_");
    const auto exponent = text.find_first_of("eE");
    if (exponent != text.npos && !is_all(without_sign(text.substr(exponent + 1)), "0123456789"))
        return false;
    text = text.substr(0, exponent);
    return is_all(text, "0123456789_,:.") && text.find('.') == text.rfind('.') &&
           is_all(text.substr(text[0] == '.', 1), "0123456789");
}

class TreeBuilder : public YAML::EventHandler {
public:
    YamlNode root;

    void OnDocumentStart(const YAML::Mark&) override {}
    void OnDocumentEnd() override {}

    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
        add(node(YamlNode::Kind::NOTHING, mark, "", anchor));
    }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
        refuse(place(mark), "a value written out", "an alias");
    }
    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string& value) override {
        YamlNode scalar = node(YamlNode::Kind::SCALAR, mark, tag, anchor);
        scalar.quoted = tag == "!";
        scalar.text = in_utf8(value);
        add(std::move(scalar));
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override {
        open(node(YamlNode::Kind::LIST, mark, tag, anchor));
    }
    void OnSequenceEnd() override { close(); }
    void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override {
        open(node(YamlNode::Kind::MAP, mark, tag, anchor));
    }
    void OnMapEnd() override { close(); }
    void OnAnchor(const YAML::Mark& mark, const std::string&) override {
        refuse(place(mark), "a value written out", "an anchor");
    }

private:
    struct Open {
        YamlNode node;
        std::map<std::string, int> key_lines;
    };

    static YamlNode place(const YAML::Mark& mark) {
        YamlNode at;
        at.line = mark.line + 1;
        at.column = mark.column + 1;
        return at;
    }

    // yaml-cpp's own tags: "?" for plain, "!" for quoted.
    static YamlNode node(YamlNode::Kind kind, const YAML::Mark& mark, const std::string& tag,
                         YAML::anchor_t anchor) {
        YamlNode made = place(mark);
        made.kind = kind;
        if (anchor) refuse(made, "a value written out", "an anchor");
        if (!tag.empty() && tag != "?" && tag != "!")
            refuse(made, "a value without a tag", "the tag " + in_quotes(tag));
        return made;
    }

    void open(YamlNode made) {
        if (open_.size() == MAX_LEVELS)
            refuse(made, "at most " + std::to_string(MAX_LEVELS) + " levels of lists and maps",
                   "one more");
        open_.push_back({std::move(made), {}});
    }

    void close() {
        YamlNode done = std::move(open_.back().node);
        open_.pop_back();
        add(std::move(done));
    }

    void add(YamlNode made) {
        if (open_.empty()) {
            root = std::move(made);
            return;
        }
        YamlNode& parent = open_.back().node;
        if (parent.kind == YamlNode::Kind::MAP && parent.keys.size() == parent.items.size())
            return add_key(std::move(made));
        if (parent.kind == YamlNode::Kind::MAP && made.kind == YamlNode::Kind::NOTHING) {
            made.line = parent.keys.back().line;  // yaml-cpp gives a place after it
            made.column = parent.keys.back().column;
        }
        parent.items.push_back(std::move(made));
    }

    void add_key(YamlNode key) {
        if (key.kind != YamlNode::Kind::SCALAR) refuse(key, "a word as key", describe(key));
        const auto [known, is_new] = open_.back().key_lines.try_emplace(key.text, key.line);
        if (!is_new)
            refuse(key, "each key once",
                   in_quotes(key.text) + " again, first in line " + std::to_string(known->second));
        open_.back().node.keys.push_back(std::move(key));
    }

    std::vector<Open> open_;
};

}  // namespace

bool is_text(const YamlNode& node) {
    static const std::set<std::string> OTHER = {
        "true", "True", "TRUE", "false", "False", "FALSE", "yes", "Yes", "YES",
        "no",   "No",   "NO",   "on",    "On",    "ON",    "off", "Off", "OFF",
        ".nan", ".NaN", ".NAN", ".inf",  ".Inf",  ".INF",  "=",   "<<"};
    if (node.kind != YamlNode::Kind::SCALAR) return false;
    return node.quoted || (OTHER.count(node.text) == 0 && !is_number(node.text));
}

std::string describe(const YamlNode& node) {
    switch (node.kind) {
        case YamlNode::Kind::NOTHING: return "nothing";
        case YamlNode::Kind::LIST: return "a list";
        case YamlNode::Kind::MAP: return "a map";
        case YamlNode::Kind::SCALAR: break;
    }
    return is_text(node) ? in_quotes(node.text) : printable(node.text.substr(0, 60));
}

void refuse(const YamlNode& at, const std::string& expected, const std::string& got) {
    throw Refusal{at.line, at.column, "expected " + expected + ", got " + got};
}

YamlNode parse_yaml(std::string_view text) {
    std::istringstream stream{std::string(text)};
    TreeBuilder builder, rest;
    try {
        YAML::Parser parser(stream);
        parser.HandleNextDocument(builder);
        if (parser.HandleNextDocument(rest)) {
            if (rest.root.line == 0) rest.root.line = rest.root.column = 1;
            refuse(rest.root, "one document", "a second");
        }
    } catch (const YAML::Exception& error) {
        throw Refusal{error.mark.line + 1, error.mark.column + 1,
                      "expected YAML, got a mistake in it: " + printable(error.msg)};
    }
    return std::move(builder.root);
}

}  // namespace sim
