#include "sim/vhdl/vhdl_source.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <vector>

#include "sim/text/lower.h"
#include "sim/vhdl/vhdl_tokens.h"

namespace sim::project {

namespace {

class VhdlScanner {
public:
    explicit VhdlScanner(std::string_view text)
        : tokens_{vhdl_tokens(text).all}, low_{in_lower_case(tokens_)} {}

    std::vector<EntityHead> heads() {
        run();
        return std::move(heads_);
    }

    SourceText run() {
        std::set<std::string> wants;  // of all architectures in the file
        for (std::size_t i = 0; i + 3 < low_.size(); ++i) {
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
    std::string text(std::size_t i) const { return std::string{tokens_[i].text}; }
    bool is(std::size_t i, std::string_view word) const { return low_[i] == word; }

    // From its name on: generic ( ... ) ; port ( ... ) ;
    void entity(std::size_t name) {
        EntityHead head{text(name), {}, {}};
        std::size_t i = name + 2;
        while (i < low_.size() && (is(i, "generic") || is(i, "port")))
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
        for (std::size_t i = open; i < low_.size(); ++i) {
            depth += is(i, "(") - is(i, ")");
            if (depth <= 0) return i + 2;
            if (depth == 1 && is(i, ";")) {
                part = NAMES;
                first = list.size();
            } else if (depth == 1 && (is(i, ":") || is(i, ":="))) {
                part = is(i, ":") ? TYPE : VALUE;
            } else if (part == TYPE) {
                for (std::size_t n = first; n < list.size(); ++n) list[n].type.push_back(low_[i]);
            } else if (part == NAMES &&
                       std::isalpha(static_cast<unsigned char>(tokens_[i].text[0])) &&
                       !is(i, "signal") && !is(i, "constant")) {
                list.push_back({text(i), {}});
            }
        }
        return low_.size();
    }

    const std::vector<Token> tokens_;
    const std::vector<std::string> low_;
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
