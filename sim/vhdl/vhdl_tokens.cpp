#include "sim/vhdl/vhdl_tokens.h"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "sim/text/lower.h"

namespace sim::project {

namespace {

bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }
bool is_number(char c) { return std::isdigit(static_cast<unsigned char>(c)); }

class VhdlReader {
public:
    explicit VhdlReader(std::string_view text) : text_{text} {}

    Tokens run() {
        Tokens tokens;
        for (;;) {
            const std::size_t gap = at_;
            skip_gap();
            if (at_ >= text_.size()) {
                tokens.tail = text_.substr(gap);
                return tokens;
            }
            const std::size_t begin = at_;
            const Token::Kind kind = read(tokens.all);
            tokens.all.push_back(
                {kind, text_.substr(begin, at_ - begin), text_.substr(gap, begin - gap), line_});
        }
    }

private:
    char peek(std::size_t ahead = 0) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }
    bool is(std::string_view what) const { return text_.compare(at_, what.size(), what) == 0; }

    void skip_gap() {
        const std::size_t begin = at_;
        for (;;) {
            if (is("--")) {
                at_ = std::min(text_.find('\n', at_), text_.size());
            } else if (is("/*")) {
                const std::size_t end = text_.find("*/", at_ + 2);
                at_ = end == std::string_view::npos ? text_.size() : end + 2;
            } else if (at_ < text_.size() && std::isspace(static_cast<unsigned char>(peek()))) {
                ++at_;
            } else {
                break;
            }
        }
        const std::string_view gap = text_.substr(begin, at_ - begin);
        line_ += static_cast<unsigned>(std::count(gap.begin(), gap.end(), '\n'));
    }

    // To the next `quote` of the line, that one taken.
    void skip_to(char quote) {
        do ++at_;
        while (at_ < text_.size() && peek() != quote && peek() != '\n');
        if (peek() == quote) ++at_;
    }

    // Whether a tick after this token is an attribute's: of a name, or of what parentheses end.
    static bool ends_name(const Token& token) {
        static constexpr std::string_view NO_NAMES[] = {
            "abs",    "and",   "case", "downto", "else", "elsif",  "if",    "in",  "is",
            "mod",    "nand",  "nor",  "not",    "or",   "rem",    "range", "rol", "ror",
            "select", "sla",   "sll",  "sra",    "srl",  "return", "then",  "to",  "until",
            "when",   "while", "with", "xnor",   "xor",  "report"};
        const std::string low = lower(std::string{token.text});
        if (token.kind == Token::Kind::NAME)
            return std::find(std::begin(NO_NAMES), std::end(NO_NAMES), low) == std::end(NO_NAMES);
        return low == ")" || low == "]" || low.back() == '"';
    }

    Token::Kind read(const std::vector<Token>& before) {
        const char c = peek();
        if (is_of_word(c)) return read_word(c);
        if (c == '\\' || c == '"') {
            skip_to(c);
            return c == '"' ? Token::Kind::STRING : Token::Kind::NAME;
        }
        if (c == '\'' && peek(2) == '\'' && (before.empty() || !ends_name(before.back()))) {
            at_ += 3;
            return Token::Kind::STRING;
        }
        static constexpr std::string_view PAIRS[] = {
            "=>", "<=", ">=", ":=", "/=", "**", "<>", "?="};
        const bool pair = std::any_of(std::begin(PAIRS), std::end(PAIRS),
                                      [this](std::string_view symbol) { return is(symbol); });
        at_ += pair ? 2 : 1;
        return Token::Kind::SYMBOL;
    }

    Token::Kind read_word(char first) {
        while (is_of_word(peek()) ||
               (is_number(first) && (peek() == '#' || (peek() == '.' && is_number(peek(1))))))
            ++at_;
        if (peek() == '"') {
            skip_to('"');
            return Token::Kind::STRING;
        }
        return is_number(first) ? Token::Kind::NUMBER : Token::Kind::NAME;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    unsigned line_ = 1;
};

}  // namespace

Tokens vhdl_tokens(std::string_view text) { return VhdlReader{text}.run(); }

std::vector<std::string> in_lower_case(const std::vector<Token>& tokens) {
    std::vector<std::string> low;
    low.reserve(tokens.size());
    for (const Token& token : tokens) {
        const std::string text{token.text};
        const bool as_it_is = token.kind == Token::Kind::STRING || text[0] == '\\';
        low.push_back(as_it_is ? text : lower(text));
    }
    return low;
}

}  // namespace sim::project
