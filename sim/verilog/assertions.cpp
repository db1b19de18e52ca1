#include "sim/verilog/assertions.h"

#include <algorithm>
#include <optional>

#include "sim/verilog/items.h"
#include "sim/verilog/tokens.h"

namespace sim::project {

namespace {

class Assertions {
public:
    explicit Assertions(std::string_view text) : text_{text}, tokens_{tokens_of(text_).all} {}

    WithoutAssertions run() {
        WithoutAssertions result{std::string{text_}};
        for (std::size_t i = 0; i < tokens_.size();) {
            const std::size_t begin = i;
            auto end = behind_declaration(i);
            if (!end) end = behind_statement_at(i);
            if (!end) {
                ++i;
                continue;
            }
            i = *end;
            if (!result.line) result.line = tokens_[begin].line;
            blank(begin, i, result.text);
        }
        return result;
    }

private:
    bool is(std::size_t i, std::string_view text) const {
        return i < tokens_.size() && tokens_[i].is(text);
    }
    bool is_one_of(std::size_t i, std::initializer_list<std::string_view> words) const {
        return i < tokens_.size() &&
               std::find(words.begin(), words.end(), tokens_[i].text) != words.end();
    }

    // property NAME ... endproperty [: NAME]
    std::optional<std::size_t> behind_declaration(std::size_t i) const {
        if (!is_one_of(i, {"property", "sequence"})) return {};
        const std::string end = "end" + std::string{tokens_[i].text};
        std::size_t at = i + 1;
        while (at < tokens_.size() && !is(at, end)) ++at;
        if (at == tokens_.size()) return {};
        return is(at + 1, ":") ? at + 3 : at + 1;
    }

    // [LABEL :] assert property (...) [statement] [else statement]
    std::optional<std::size_t> behind_statement_at(std::size_t i) const {
        if (tokens_[i].kind == Token::Kind::NAME && is(i + 1, ":")) i += 2;
        if (!is_one_of(i, {"assert", "assume", "cover", "restrict"}) ||
            !is_one_of(i + 1, {"property", "sequence"}) || !is(i + 2, "("))
            return {};
        std::size_t at = closing(tokens_, i + 2) + 1;
        if (at < tokens_.size() && !is(at, "else")) at = behind_statement(tokens_, at);
        if (is(at, "else")) at = behind_statement(tokens_, at + 1);
        return at;
    }

    // Lines stay, and the semicolon of a statement.
    void blank(std::size_t begin, std::size_t end, std::string& text) const {
        const Token& last = tokens_[std::min(end, tokens_.size()) - 1];
        const auto from = static_cast<std::size_t>(tokens_[begin].text.data() - text_.data());
        const auto to =
            static_cast<std::size_t>(last.text.data() - text_.data()) + last.text.size();
        for (std::size_t at = from; at < to; ++at)
            if (text[at] != '\n') text[at] = ' ';
        if (items_.is_statement(begin)) text[to - 1] = ';';
    }

    const std::string_view text_;
    const std::vector<Token> tokens_;
    const Items items_{tokens_};
};

}  // namespace

WithoutAssertions without_assertions(std::string_view text) { return Assertions{text}.run(); }

}  // namespace sim::project
