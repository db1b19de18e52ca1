#include "sim/verilog/tokens.h"

#include <algorithm>
#include <cctype>
#include <iterator>

namespace sim::project {

namespace {

bool starts_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '$'; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)); }
bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)); }

class Scanner {
public:
    explicit Scanner(std::string_view text) : text_{text} {}

    Tokens run() {
        Tokens tokens;
        tokens.all.reserve(text_.size() / 4);  // bytes per token
        for (;;) {
            const std::size_t gap = at_;
            skip_gap();
            if (at_ >= text_.size()) {
                tokens.tail = text_.substr(gap);
                return tokens;
            }
            const std::size_t begin = at_;
            const unsigned line = line_;
            const Token::Kind kind = read();
            for (std::size_t i = begin; i < at_; ++i) line_ += text_[i] == '\n';
            tokens.all.push_back(
                {kind, text_.substr(begin, at_ - begin), text_.substr(gap, begin - gap), line});
        }
    }

private:
    char peek(std::size_t ahead = 0) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }
    template <class Test>
    void skip_while(Test test) {
        while (at_ < text_.size() && test(text_[at_])) ++at_;
    }
    void skip_to(std::string_view end) {
        const std::size_t found = text_.find(end, at_);
        at_ = found == std::string_view::npos ? text_.size() : found + end.size();
    }

    void skip_gap() {
        const std::size_t begin = at_;
        for (;;) {
            skip_while(is_space);
            if (peek() == '/' && peek(1) == '/') {
                skip_while([](char c) { return c != '\n'; });
            } else if (peek() == '/' && peek(1) == '*') {
                at_ += 2;
                skip_to("*/");
            } else if (peek() == '`' && is_directive()) {
                skip_directive();
            } else {
                break;
            }
        }
        line_ += static_cast<unsigned>(
            std::count(text_.begin() + static_cast<std::ptrdiff_t>(begin),
                       text_.begin() + static_cast<std::ptrdiff_t>(at_), '\n'));
    }

    std::string_view word_at(std::size_t begin) const {
        std::size_t end = begin;
        while (end < text_.size() && in_name(text_[end])) ++end;
        return text_.substr(begin, end - begin);
    }

    bool is_directive() const {
        static constexpr std::string_view DIRECTIVES[] = {"begin_keywords",
                                                          "celldefine",
                                                          "default_nettype",
                                                          "define",
                                                          "else",
                                                          "elsif",
                                                          "end_keywords",
                                                          "endcelldefine",
                                                          "endif",
                                                          "ifdef",
                                                          "ifndef",
                                                          "include",
                                                          "line",
                                                          "nounconnected_drive",
                                                          "pragma",
                                                          "resetall",
                                                          "timescale",
                                                          "unconnected_drive",
                                                          "undef"};
        const std::string_view word = word_at(at_ + 1);
        return std::find(std::begin(DIRECTIVES), std::end(DIRECTIVES), word) !=
               std::end(DIRECTIVES);
    }

    // To the end of the line, where that is not a continued one; `endif and its like end sooner.
    void skip_directive() {
        const std::string_view word = word_at(at_ + 1);
        at_ += 1 + word.size();
        if (word == "else" || word == "endif" || word == "celldefine" || word == "endcelldefine" ||
            word == "resetall" || word == "end_keywords")
            return;
        if (word == "ifdef" || word == "ifndef" || word == "elsif" || word == "undef") {
            skip_while([](char c) { return c == ' ' || c == '\t'; });
            skip_while(in_name);
            return;
        }
        while (at_ < text_.size() && text_[at_] != '\n') {
            if (text_[at_] == '/' && peek(1) == '/') return;
            if (text_[at_] == '\\') {
                ++at_;
                if (peek() == '\r') ++at_;
            }
            ++at_;
        }
        at_ = std::min(at_, text_.size());
    }

    Token::Kind read() {
        const char c = peek();
        if (starts_name(c) || c == '$') {
            ++at_;
            skip_while(in_name);
            return Token::Kind::NAME;
        }
        if (c == '\\') {  // an escaped name
            skip_while([](char x) { return !is_space(x); });
            return Token::Kind::NAME;
        }
        if (c == '`') {
            ++at_;
            skip_while(in_name);
            return Token::Kind::MACRO;
        }
        if (c == '"') {
            ++at_;
            while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
            at_ = std::min(at_ + 1, text_.size());
            return Token::Kind::STRING;
        }
        if (is_digit(c) || (c == '\'' && base_at(at_))) return read_number();
        ++at_;
        if ((c == '(' && peek() == '*' && peek(1) != ')') || (c == '*' && peek() == ')') ||
            (c == ':' && peek() == ':'))
            ++at_;
        return Token::Kind::SYMBOL;
    }

    bool base_at(std::size_t quote) const {
        std::size_t i = quote + 1;
        if (i < text_.size() && (text_[i] == 's' || text_[i] == 'S')) ++i;
        return i < text_.size() &&
               std::string_view{"bBoOdDhH"}.find(text_[i]) != std::string_view::npos;
    }

    Token::Kind read_number() {
        const auto digits = [](char c) {
            return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '?' || c == '.';
        };
        if (peek() != '\'') skip_while(digits);
        std::size_t quote = at_;
        while (quote < text_.size() && (text_[quote] == ' ' || text_[quote] == '\t')) ++quote;
        if (quote >= text_.size() || text_[quote] != '\'' || !base_at(quote))
            return Token::Kind::NUMBER;
        at_ = quote + 1;
        if (peek() == 's' || peek() == 'S') ++at_;
        ++at_;
        skip_while([](char c) { return c == ' ' || c == '\t'; });
        skip_while(digits);
        return Token::Kind::NUMBER;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    unsigned line_ = 1;
};

}  // namespace

Tokens tokens_of(std::string_view text) { return Scanner{text}.run(); }

std::string text_between(const std::vector<Token>& tokens, std::size_t begin, std::size_t end) {
    std::string text;
    for (std::size_t i = begin; i < end; ++i) {
        if (i > begin && !tokens[i].gap.empty()) text += ' ';
        text += tokens[i].text;
    }
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

void follow_conditions(std::string_view gap, unsigned& open) {
    for (std::size_t at = gap.find('`'); at != std::string_view::npos; at = gap.find('`', at + 1)) {
        const std::string_view word = gap.substr(at + 1, 6);
        if (word.substr(0, 5) == "ifdef" || word == "ifndef") ++open;
        if (word.substr(0, 5) == "endif" && open) --open;
    }
}

bool is_keyword(std::string_view name) {
    static constexpr std::string_view KEYWORDS[] = {
        "always",    "and",        "assign",   "automatic", "begin",       "buf",
        "bufif0",    "bufif1",     "case",     "casex",     "casez",       "cell",
        "config",    "deassign",   "default",  "defparam",  "design",      "disable",
        "edge",      "else",       "end",      "endcase",   "endfunction", "endgenerate",
        "endmodule", "endspecify", "endtask",  "event",     "for",         "force",
        "forever",   "fork",       "function", "generate",  "genvar",      "if",
        "initial",   "inout",      "input",    "integer",   "join",        "localparam",
        "module",    "nand",       "negedge",  "nor",       "not",         "notif0",
        "notif1",    "or",         "output",   "parameter", "posedge",     "pulldown",
        "pullup",    "real",       "realtime", "reg",       "release",     "repeat",
        "scalared",  "signed",     "specify",  "supply0",   "supply1",     "task",
        "time",      "tran",       "tri",      "tri0",      "tri1",        "unsigned",
        "vectored",  "wait",       "wand",     "while",     "wire",        "wor",
        "xnor",      "xor"};
    return std::find(std::begin(KEYWORDS), std::end(KEYWORDS), name) != std::end(KEYWORDS);
}

}  // namespace sim::project
