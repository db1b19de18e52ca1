#include "sim/vhdl/vhdl_source.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <vector>

#include "sim/text/lower.h"

namespace sim::project {

namespace {

struct Word {
    std::string_view text, low;  // as written, and in lower case
};

// Words and symbols without comments; `low` is the text in lower case.
std::vector<Word> words_of(std::string_view text, std::string_view low) {
    std::vector<Word> words;
    const auto copy = [&](std::size_t begin, std::size_t count) {
        words.push_back({text.substr(begin, count), low.substr(begin, count)});
    };
    const auto in_word = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    };
    for (std::size_t i = 0; i < text.size();) {
        if (text.compare(i, 2, "--") == 0) {
            i = std::min(text.find('\n', i), text.size());
        } else if (in_word(text[i])) {
            const std::size_t begin = i;
            while (i < text.size() && in_word(text[i])) ++i;
            copy(begin, i - begin);
        } else {
            if (!std::isspace(static_cast<unsigned char>(text[i]))) copy(i, 1);
            ++i;
        }
    }
    return words;
}

class VhdlScanner {
public:
    explicit VhdlScanner(std::string_view text)
        : low_{lower(std::string{text})}, words_{words_of(text, low_)} {}

    std::vector<EntityHead> heads() {
        run();
        return std::move(heads_);
    }

    SourceText run() {
        std::set<std::string> wants;  // of all architectures in the file
        for (std::size_t i = 0; i + 3 < words_.size(); ++i) {
            const bool ends = i > 0 && is(i - 1, "end");
            if (is(i, "entity") && is(i + 2, "is"))
                entity(i + 1);
            else if (is(i, "entity") && is(i + 2, "."))  // of any library
                wants.insert(text(i + 3));
            else if (is(i, "package") && !is(i + 1, "body") && is(i + 2, "is"))
                source_.modules.push_back({text(i + 1), 0, {}, {}, true});
            else if (is(i, "component") && !ends)
                wants.insert(text(i + 1));
            else if (is(i, "work") && is(i + 1, "."))
                wants.insert(text(i + 2));
        }
        for (ModuleText& module : source_.modules) module.wants = wants;
        return std::move(source_);
    }

private:
    std::string text(std::size_t i) const { return std::string{words_[i].text}; }
    bool is(std::size_t i, std::string_view word) const { return words_[i].low == word; }

    // From its name on: generic ( ... ) ; port ( ... ) ;
    void entity(std::size_t name) {
        EntityHead head{text(name), {}, {}};
        std::size_t i = name + 2;
        while (i < words_.size() && (is(i, "generic") || is(i, "port")))
            i = members(i + 1, is(i, "port") ? head.ports : head.generics);
        source_.modules.push_back({text(name), 0, {}, {}, false});
        for (const auto& port : head.ports) source_.modules.back().ports.push_back(port.name);
        heads_.push_back(std::move(head));
    }
    // ( a, b : in std_logic := '0'; ... ) ; and returns what is after it.
    std::size_t members(std::size_t open, std::vector<EntityHead::Member>& list) {
        int depth = 0;
        enum { NAMES, TYPE, VALUE } part = NAMES;
        std::size_t first = list.size();  // of those that share a type
        for (std::size_t i = open; i < words_.size(); ++i) {
            depth += is(i, "(") - is(i, ")");
            if (depth <= 0) return i + 2;
            if (depth == 1 && is(i, ";")) {
                part = NAMES;
                first = list.size();
            } else if (depth == 1 && is(i, ":")) {
                part = part == NAMES ? TYPE : VALUE;
            } else if (part == TYPE) {
                for (std::size_t n = first; n < list.size(); ++n)
                    list[n].type.emplace_back(words_[i].low);
            } else if (part == NAMES &&
                       std::isalpha(static_cast<unsigned char>(words_[i].text[0])) &&
                       !is(i, "signal") && !is(i, "constant")) {
                list.push_back({text(i), {}});
            }
        }
        return words_.size();
    }

    const std::string low_;
    const std::vector<Word> words_;
    SourceText source_;
    std::vector<EntityHead> heads_;
};

}  // namespace

SourceText scan_vhdl(std::string_view text) { return VhdlScanner{text}.run(); }

std::vector<EntityHead> entities_in(std::string_view text) { return VhdlScanner{text}.heads(); }

std::optional<EntityHead> entity_in(std::string_view text, const std::string& name) {
    for (EntityHead& head : entities_in(text))
        if (lower(head.name) == lower(name)) return std::move(head);
    return {};
}

}  // namespace sim::project
