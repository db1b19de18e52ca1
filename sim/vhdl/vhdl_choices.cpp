#include "sim/vhdl/vhdl_choices.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "sim/verilog/edits.h"
#include "sim/vhdl/vhdl_tokens.h"

namespace sim::project {

namespace {

using At = std::size_t;  // a token's number

struct Alternative {
    At when, begin, end;  // of its choices; `end` is =>, a comma or a semicolon
};
struct Statement {
    bool is_case;
    At begin, expression, expression_end;  // the latter: `is` or `select`
    std::vector<Alternative> alternatives;
    At end;  // of a case: `end`
};

class ChoiceRewriter {
public:
    explicit ChoiceRewriter(const std::string& text)
        : tokens_{vhdl_tokens(text)}, low_{in_lower_case(tokens_.all)} {
        find_statements();
    }

    std::optional<ChoicesAsConditions> run(const std::set<unsigned>& lines,
                                           const std::set<unsigned>& incomplete) {
        for (const Statement& statement : statements_)
            if ((has_choice_on(statement, lines) ||
                 (has_choice_on(statement, incomplete) && has_all_bits(statement))) &&
                can_be_rewritten(statement))
                rewrite(statement);
        if (rewritten_.empty()) return {};
        return ChoicesAsConditions{changed_text(tokens_, edits_), rewritten_};
    }

private:
    bool is(At i, std::string_view what) const { return i < low_.size() && low_[i] == what; }

    // The first of `words` from `i` on that is in no parentheses; a semicolon ends the search.
    std::optional<At> find(At i, std::initializer_list<std::string_view> words, At end) const {
        int depth = 0;
        for (; i < end; ++i) {
            depth += is(i, "(") - is(i, ")");
            if (depth > 0) continue;
            if (std::find(words.begin(), words.end(), low_[i]) != words.end()) return i;
            if (is(i, ";") || depth < 0) return {};
        }
        return {};
    }
    std::optional<At> find(At i, std::initializer_list<std::string_view> words) const {
        return find(i, words, low_.size());
    }

    void find_statements() {
        std::vector<Statement> open;  // cases
        for (At i = 0; i < low_.size(); ++i) {
            if (is(i, "case") && i > 0 && is(i - 1, "end")) {
                if (open.empty()) continue;
                open.back().end = i - 1;
                statements_.push_back(std::move(open.back()));
                open.pop_back();
            } else if (is(i, "case")) {
                if (const auto end = find(i + 1, {"is", "generate"}); end && is(*end, "is"))
                    open.push_back({true, i, i + 1, *end, {}, 0});
            } else if (is(i, "with")) {
                selected_assignment(i);
            } else if (is(i, "when") && i > 0 && !open.empty() &&
                       (is(i - 1, "is") || is(i - 1, ";") || is(i - 1, "=>"))) {
                if (const auto arrow = find(i + 1, {"=>"}))
                    open.back().alternatives.push_back({i, i + 1, *arrow});
            }
        }
    }

    void selected_assignment(At with) {
        const auto select = find(with + 1, {"select"});
        const auto arrow = select ? find(*select + 1, {"<=", ":="}) : std::nullopt;
        if (!arrow) return;
        Statement statement{false, with, with + 1, *select, {}, 0};
        for (At i = *arrow + 1;;) {
            const auto when = find(i, {"when"});
            const auto end = when ? find(*when + 1, {",", ";"}) : std::nullopt;
            if (!end) return;
            statement.alternatives.push_back({*when, *when + 1, *end});
            if (is(*end, ";")) break;
            i = *end + 1;
        }
        statements_.push_back(std::move(statement));
    }

    bool has_choice_on(const Statement& statement, const std::set<unsigned>& lines) const {
        for (const Alternative& one : statement.alternatives)
            for (At i = one.when; i < one.end; ++i)
                if (lines.count(tokens_.all[i].line)) return true;
        return false;
    }

    // Whether each combination of 0 and 1 is a choice, and nothing else.
    bool has_all_bits(const Statement& statement) const {
        std::set<std::string> choices;
        for (const Alternative& one : statement.alternatives)
            for (At i = one.begin; i < one.end; ++i) {
                if (is(i, "|")) continue;
                const std::string bits = low_[i].substr(1, low_[i].size() - 2);
                if (tokens_.all[i].kind != Token::Kind::STRING || bits.empty() ||
                    bits.size() > 16 || bits.find_first_not_of("01") != std::string::npos)
                    return false;
                choices.insert(bits);
            }
        return !choices.empty() && choices.size() == std::size_t{1} << choices.begin()->size();
    }

    // A literal of std_logic with Z or the like equals nothing, which = would not say.
    bool has_other_bits(At i) const {
        const std::string& literal = low_[i];
        const std::size_t open = literal.find_first_of("\"'");
        return tokens_.all[i].kind == Token::Kind::STRING &&
               literal.find_first_of("UXZWLH-uxzwlh", open) != std::string::npos;
    }

    bool can_be_rewritten(const Statement& statement) const {
        const auto& all = statement.alternatives;
        if (all.empty() || (statement.is_case && all.size() < 2)) return false;
        // Of `case?` and `select?`, and of what is broken.
        if (statement.expression == statement.expression_end || is(statement.expression, "?") ||
            is(statement.expression_end + 1, "?"))
            return false;
        for (const Alternative& one : all) {
            if (one.begin == one.end || (is(one.begin, "others") && &one != &all.back()))
                return false;
            for (At i = one.begin; i < one.end; ++i)
                if (has_other_bits(i)) return false;
        }
        return true;
    }

    void replace(At i, const std::string& text) {
        edits_.left_out.insert(i);
        edits_.before[i] += text;
        rewritten_.insert(tokens_.all[i].line);
    }
    void leave_out(At begin, At end) {
        for (At i = begin; i < end; ++i) replace(i, "");
    }

    void rewrite(const Statement& statement) {
        const std::string value = fmt::format(
            "({})", text_between(tokens_.all, statement.expression, statement.expression_end));
        replace(statement.begin, statement.is_case ? "if " : "");
        leave_out(statement.expression, statement.expression_end + 1);
        const auto& all = statement.alternatives;
        for (const Alternative& one : all) {
            const bool is_first = &one == &all.front(), is_last = &one == &all.back();
            if (statement.is_case)
                replace(one.when, is_first ? "" : is_last ? " else " : " elsif ");
            if (is_last) {
                leave_out(one.when + statement.is_case, one.end);
                if (statement.is_case) replace(one.end, " ");
                continue;
            }
            conditions(value, one);
            replace(one.end, statement.is_case ? " then " : " else ");
        }
        if (statement.is_case) replace(statement.end + 1, "if");
    }

    void conditions(const std::string& value, const Alternative& one) {
        for (At begin = one.begin; begin < one.end;) {
            const At end = find(begin, {"|"}, one.end).value_or(one.end);
            condition(value, begin, end);
            if (end < one.end) replace(end, " or ");
            begin = end + 1;
        }
    }

    void condition(const std::string& value, At begin, At end) {
        if (begin == end) return;
        for (At i = begin + 2; i < end; ++i)  // X'range, X'reverse_range, X'range(1)
            if (is(i - 1, "'") && (is(i, "range") || is(i, "reverse_range"))) {
                const std::string of = text_between(tokens_.all, begin, i - 1),
                                  dimension = text_between(tokens_.all, i + 1, end);
                leave_out(begin, end);
                edits_.before[begin] +=
                    fmt::format("({0} >= {1}'low{2} and {0} <= {1}'high{2})", value, of, dimension);
                return;
            }
        if (const auto range = find(begin, {"range"}, end)) {  // integer range 0 to 3
            leave_out(begin, *range + 1);
            begin = *range + 1;
        }
        const auto to = find(begin, {"to", "downto"}, end);
        const bool is_up = to && is(*to, "to");
        edits_.before[begin] += fmt::format("({} {} (", value, !to ? "=" : is_up ? ">=" : "<=");
        if (to) replace(*to, fmt::format(") and {} {} (", value, is_up ? "<=" : ">="));
        edits_.after[end - 1] += "))";
    }

    const Tokens tokens_;
    const std::vector<std::string> low_;
    std::vector<Statement> statements_;
    Edits edits_;
    std::set<unsigned> rewritten_;
};

}  // namespace

std::optional<ChoicesAsConditions> choices_as_conditions(const std::string& text,
                                                         const std::set<unsigned>& lines,
                                                         const std::set<unsigned>& incomplete) {
    return ChoiceRewriter{text}.run(lines, incomplete);
}

}  // namespace sim::project
