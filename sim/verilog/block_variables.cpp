#include "sim/verilog/block_variables.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "sim/verilog/items.h"

namespace sim::project {

namespace {

bool is_variable_type(std::string_view word) {
    static constexpr std::string_view WORDS[] = {"reg",  "logic", "bit",     "integer",  "int",
                                                 "byte", "var",   "longint", "shortint", "static"};
    return std::find(std::begin(WORDS), std::end(WORDS), word) != std::end(WORDS);
}

class BlockVariables {
public:
    BlockVariables(const std::vector<Token>& tokens, std::size_t always, Edits& edits)
        : tokens_{tokens}, always_{always}, edits_{edits} {}

    // The tokens [at, end) are its statement.
    void look(std::size_t at, std::size_t end) {
        for (; at < end; ++at) {
            const Token& token = tokens_[at];
            if (token.is("begin")) {
                open(at);
            } else if (token.is("end")) {
                if (!blocks_.empty()) blocks_.pop_back();
            } else if (is_variable_type(token.text) && begins_line(at)) {
                at = declaration(at, end);
            }
        }
    }

private:
    struct Block {
        std::size_t begin;
        std::string name;  // empty: it has none
    };

    void open(std::size_t at) {
        const bool is_named = at + 2 < tokens_.size() && tokens_[at + 1].is(":");
        blocks_.push_back({at, is_named ? std::string{tokens_[at + 2].text} : ""});
    }

    bool begins_line(std::size_t at) const {
        const Token& before = tokens_[at - 1];
        return before.is("begin") || before.is(";") || (at > 2 && tokens_[at - 2].is(":"));
    }

    // Returns its last token.
    std::size_t declaration(std::size_t at, std::size_t end) {
        std::size_t depth = 0, name = 0, value = 0;
        bool is_array = false;
        for (; at < end; ++at) {
            const Token& token = tokens_[at];
            const bool ends = depth == 0 && (token.is(",") || token.is(";"));
            if (ends && value && !is_array) begin_with(name, value, at);
            if (ends) value = name = 0, is_array = false;
            if (token.is(";")) return at;
            if (token.is("(") || token.is("[") || token.is("{")) {
                if (depth == 0 && !value && name && token.is("[")) is_array = true;
                ++depth;
            } else if (token.is(")") || token.is("]") || token.is("}")) {
                --depth;
            } else if (depth == 0 && token.is("=") && !value) {
                value = at;
            } else if (depth == 0 && !value && token.kind == Token::Kind::NAME &&
                       !is_variable_type(token.text) && !token.is("signed") &&
                       !token.is("unsigned")) {
                name = at;
            }
        }
        return at;
    }

    // The tokens [equals, end) leave the declaration.
    void begin_with(std::size_t name, std::size_t equals, std::size_t end) {
        if (!name || blocks_.empty()) return;
        for (std::size_t n = equals; n < end; ++n)
            if (tokens_[n].gap.find('`') != std::string_view::npos) return;
        std::string path;
        for (Block& block : blocks_) {
            if (block.name.empty()) {
                block.name = fmt::format("de1sim_block_{}", block.begin);
                edits_.after[block.begin] = " : " + block.name + edits_.after[block.begin];
            }
            path += block.name + ".";
        }
        edits_.before[always_] += fmt::format("initial {}{} = {}; ", path, tokens_[name].text,
                                              text_between(tokens_, equals + 1, end));
        for (std::size_t n = equals; n < end; ++n) edits_.left_out.insert(n);
        edits_.notes[name] = fmt::format(
            "{} begins with its value at power-up, and keeps what it has", tokens_[name].text);
    }

    const std::vector<Token>& tokens_;
    const std::size_t always_;
    Edits& edits_;
    std::vector<Block> blocks_;  // that are open
};

}  // namespace

void begin_block_variables(const std::vector<Token>& tokens, Edits& edits) {
    for (std::size_t at = 0; at + 3 < tokens.size(); ++at) {
        if (!(tokens[at].is("always") || tokens[at].is("always_ff")) || !tokens[at + 1].is("@") ||
            !tokens[at + 2].is("("))
            continue;
        const std::size_t close = closing(tokens, at + 2);
        const auto token = [&](std::size_t i) {
            return tokens.begin() + static_cast<std::ptrdiff_t>(i);
        };
        if (close + 1 >= tokens.size() ||
            std::none_of(token(at + 3), token(close),
                         [](const Token& one) { return one.is("posedge") || one.is("negedge"); }))
            continue;
        const std::size_t end = std::min(behind_statement(tokens, close + 1), tokens.size());
        BlockVariables{tokens, at, edits}.look(close + 1, end);
    }
}

}  // namespace sim::project
