#include "sim/verilog/items.h"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace sim::project {

namespace {

// Each function takes the index of a construct's first token and returns the one after its end.
class Statements {
public:
    explicit Statements(const std::vector<Token>& tokens) : tokens_{tokens} {}

    std::size_t to_behind(std::size_t i, std::string_view end) const {
        while (i < tokens_.size() && !tokens_[i].is(end)) ++i;
        return std::min(i + 1, tokens_.size());
    }

    // `nested` blocks in one another, which is no depth that a person writes, end the search.
    std::size_t statement(std::size_t i, unsigned nested = 0) const {
        if (i >= tokens_.size() || nested > MOST_NESTED) return tokens_.size();
        const Token& token = tokens_[i];
        if (token.is("begin") || token.is("fork"))
            return block(i + 1, token.is("begin") ? "end" : "join", nested);
        if (token.is("case") || token.is("casex") || token.is("casez")) return cases(i);
        if (token.is("if")) {
            i = statement(behind_parentheses(i + 1), nested + 1);
            return i < tokens_.size() && tokens_[i].is("else") ? statement(i + 1, nested + 1) : i;
        }
        if (token.is("for") || token.is("while") || token.is("repeat") || token.is("wait"))
            return statement(behind_parentheses(i + 1), nested + 1);
        if (token.is("forever") || token.is("unique") || token.is("priority"))
            return statement(i + 1, nested + 1);
        if (token.is("@") || token.is("#")) {
            i = is(i + 1, "(") || is(i + 1, "(*") ? behind_parentheses(i + 1) : i + 2;
            return statement(i, nested + 1);
        }
        return to_behind(i, ";");
    }

private:
    static constexpr unsigned MOST_NESTED = 500;

    bool is(std::size_t i, std::string_view text) const {
        return i < tokens_.size() && tokens_[i].is(text);
    }
    // "(*)" of an event control comes as "(*" and ")", or as "(" and "*)".
    std::size_t behind_parentheses(std::size_t i) const {
        if (is(i, "(*") && is(i + 1, ")")) return i + 2;
        if (is(i, "(") && is(i + 1, "*)")) return i + 2;
        return is(i, "(") ? closing(tokens_, i) + 1 : i;
    }
    std::size_t block(std::size_t i, std::string_view end, unsigned nested) const {
        if (is(i, ":")) i += 2;  // its name
        while (i < tokens_.size() && !tokens_[i].is(end)) i = statement(i, nested + 1);
        i = std::min(i + 1, tokens_.size());
        return is(i, ":") ? i + 2 : i;
    }
    std::size_t cases(std::size_t i) const {
        unsigned depth = 0;
        for (; i < tokens_.size(); ++i) {
            depth += tokens_[i].is("case") || tokens_[i].is("casex") || tokens_[i].is("casez");
            if (tokens_[i].is("endcase") && --depth == 0) return i + 1;
        }
        return i;
    }

    const std::vector<Token>& tokens_;
};

bool begins_process(const Token& token) {
    static constexpr std::string_view WORDS[] = {"always",       "always_comb", "always_ff",
                                                 "always_latch", "final",       "initial"};
    return std::find(std::begin(WORDS), std::end(WORDS), token.text) != std::end(WORDS);
}

}  // namespace

std::size_t behind_statement(const std::vector<Token>& tokens, std::size_t i) {
    return Statements{tokens}.statement(i);
}

std::size_t closing(const std::vector<Token>& tokens, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < tokens.size(); ++i) {
        depth += tokens[i].is("(") - tokens[i].is(")");
        if (depth == 0) return i;
    }
    return tokens.size() - 1;
}

Items::Items(const std::vector<Token>& tokens) : tokens_{tokens}, statements_(tokens.size()) {
    const Statements statements{tokens};
    for (std::size_t i = 0; i < tokens.size();) {
        std::size_t end = i + 1;
        if (tokens[i].is("function")) {
            end = statements.to_behind(i, "endfunction");
        } else if (tokens[i].is("task")) {
            end = statements.to_behind(i, "endtask");
        } else if (begins_process(tokens[i])) {
            end = statements.statement(i + 1);
        } else {
            ++i;
            continue;
        }
        std::fill(statements_.begin() + static_cast<std::ptrdiff_t>(i),
                  statements_.begin() + static_cast<std::ptrdiff_t>(end), true);
        i = end;
    }
}

bool Items::unnamed_instance(std::size_t i) const {
    const Token& token = tokens_[i];
    if (token.kind != Token::Kind::NAME || token.text[0] == '$' || is_keyword(token.text) ||
        i + 1 == tokens_.size() || !begins_item(i))
        return false;
    std::size_t open = i + 1;
    if (tokens_[open].is("#")) open = closing(tokens_, open + 1) + 1;
    return open < tokens_.size() && tokens_[open].is("(");
}

// After the name of a block, too.
bool Items::begins_item(std::size_t i) const {
    if (i == 0 || statements_[i]) return false;
    static constexpr std::string_view BEFORE[] = {";",           "begin",  "end",     "*)",
                                                  "generate",    "else",   "endcase", "endgenerate",
                                                  "endfunction", "endtask"};
    const auto is_one = [](const Token& before) {
        return std::find(std::begin(BEFORE), std::end(BEFORE), before.text) != std::end(BEFORE);
    };
    return is_one(tokens_[i - 1]) || (i > 2 && tokens_[i - 2].is(":") && is_one(tokens_[i - 3]));
}

}  // namespace sim::project
