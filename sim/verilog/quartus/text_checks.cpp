#include "sim/verilog/quartus/text_checks.h"

#include <algorithm>

#include <fmt/format.h>

#include "sim/text/lower.h"
#include "sim/verilog/clocked_block.h"

namespace sim::project {

namespace {

using Kind = Token::Kind;

bool is_plain_name(const Token& t) {
    return t.kind == Kind::NAME && !is_keyword(t.text) && t.text[0] != '$';
}

// Whether an expression has the 32 bits of a number without a size, by the standard's rules.
class Widths {
public:
    Widths(const std::vector<Token>& all, const std::set<std::string_view>& integers)
        : all_{all}, integers_{integers} {}

    // From token `i` to the one at `end`.
    bool is_wide(std::size_t i, std::size_t end) {
        at_ = i;
        end_ = end;
        return i + 1 < end && choice(0) && at_ == end_;
    }

private:
    bool is(std::string_view text, std::size_t ahead = 0) const {
        return at_ + ahead < end_ && all_[at_ + ahead].is(text);
    }
    bool choice(unsigned depth) {
        const bool first = binary(0, depth);
        if (!is("?")) return first;
        ++at_;
        const bool a = choice(depth + 1);
        if (!is(":")) return false;
        ++at_;
        const bool b = choice(depth + 1);
        return a || b;
    }

    // The binary operator here: its level, and how many tokens it has.
    std::pair<int, unsigned> operation() const {
        static const std::vector<std::vector<std::vector<std::string_view>>> LEVELS{
            {{"|", "|"}},
            {{"&", "&"}},
            {{"|"}},
            {{"^", "~"}, {"~", "^"}, {"^"}},
            {{"&"}},
            {{"=", "=", "="}, {"!", "=", "="}, {"=", "="}, {"!", "="}},
            {{"<", "="}, {">", "="}, {"<"}, {">"}},
            {{"<", "<", "<"}, {">", ">", ">"}, {"<", "<"}, {">", ">"}},
            {{"+"}, {"-"}},
            {{"*"}, {"/"}, {"%"}}};
        int level = -1;
        unsigned length = 0;
        for (std::size_t n = 0; n < LEVELS.size(); ++n)
            for (const auto& sign : LEVELS[n]) {
                bool here = sign.size() > length;
                for (std::size_t i = 0; here && i < sign.size(); ++i)
                    here = is(sign[i], i) && (i == 0 || all_[at_ + i].gap.empty());
                if (here) {
                    level = static_cast<int>(n);
                    length = static_cast<unsigned>(sign.size());
                }
            }
        return {level, length};
    }
    bool binary(int least, unsigned depth) {
        bool wide = unary(depth);
        for (;;) {
            const auto [level, length] = operation();
            if (level < least || depth > MOST_NESTED_EXPRESSIONS) return wide;
            at_ += length;
            const bool right = binary(level + 1, depth + 1);
            if (level <= 1 || level == 5 || level == 6)
                wide = false;  // one bit
            else if (level != 7)
                wide = wide || right;
        }
    }
    bool unary(unsigned depth) {
        if (depth > MOST_NESTED_EXPRESSIONS) at_ = end_;
        if (at_ >= end_) return false;
        if (is("+") || is("-") || is("~")) {
            ++at_;
            const bool reduces = is("&") || is("|") || is("^");
            return unary(depth + 1) && !reduces;
        }
        if (is("!") || is("&") || is("|") || is("^")) {
            ++at_;
            unary(depth + 1);
            return false;
        }
        return primary(depth);
    }
    bool primary(unsigned depth) {
        const Token& token = all_[at_];
        if (is("(")) {
            ++at_;
            const bool wide = choice(depth + 1);
            if (is(")")) ++at_;
            return wide;
        }
        if (is("{")) {
            skip("{", "}");
            return false;
        }
        ++at_;
        if (token.kind == Kind::NUMBER) {
            const std::size_t quote = token.text.find('\'');
            return quote == std::string_view::npos || quote == 0;
        }
        bool wide = token.kind == Kind::NAME && integers_.count(token.text) > 0;
        while (is("[") || is("(") || is(".")) {
            wide = false;
            if (is("."))
                at_ += 2;
            else if (is("["))
                skip("[", "]");
            else
                skip("(", ")");
        }
        return wide;
    }
    void skip(std::string_view open, std::string_view close) {
        int depth = 0;
        do {
            depth += is(open) - is(close);
            ++at_;
        } while (depth > 0 && at_ < end_);
    }

    static constexpr unsigned MOST_NESTED_EXPRESSIONS = 200;
    const std::vector<Token>& all_;
    const std::set<std::string_view>& integers_;
    std::size_t at_ = 0, end_ = 0;
};

class TextChecker {
public:
    TextChecker(const std::vector<Token>& all, const Items& items, const std::string& name,
                bool system_verilog)
        : all_{all}, items_{items}, name_{name}, system_verilog_{system_verilog} {}

    TextChecks run() {
        for (std::size_t i = 0; i < all_.size(); ++i) {
            const Token& token = all_[i];
            follow_conditions(token.gap, conditions_);
            if (token.is("module") || token.is("macromodule")) begin_module(i);
            if (token.is("endmodule")) generate_ = 0;
            if (token.is("generate")) ++generate_;
            if (token.is("endgenerate") && generate_) --generate_;
            if (!system_verilog_ && !generate_ && token.is("for") && items_.begins_item(i) &&
                in_module_body(i))
                error(10170, token,
                      fmt::format("near \"{}\"; Verilog-2001 wants `generate` around it, or name "
                                  "the file a SYSTEMVERILOG_FILE",
                                  token.text));
            if (token.is("always") || token.is("always_ff")) block(i);
            if (token.kind == Kind::NAME && token.text[0] == '$') system_task(token);
            if (token.kind == Kind::NUMBER) literal(token);
            if (token.is("parameter")) parameter(i);
            if (token.is("integer") || token.is("genvar") || token.is("int")) integers(i);
            if (token.is("=")) assignment(i);
            if (token.is("reg") || token.is("integer")) registers(i);
            if (token.is("assign") && items_.begins_item(i)) assigns_.push_back(i);
            if (token.is("endmodule")) assigned_registers();
        }
        return std::move(checks_);
    }

private:
    void error(unsigned number, const Token& token, std::string text) {
        if (conditions_) return;
        checks_.errors.push_back({number, name_, token.line, std::move(text)});
    }
    void warn(unsigned number, const Token& token, std::string text) {
        if (conditions_) return;
        checks_.warnings.push_back({number, name_, token.line, std::move(text)});
    }
    bool is(std::size_t i, std::string_view text) const {
        return i < all_.size() && all_[i].is(text);
    }

    void begin_module(std::size_t i) {
        has_parameter_list_ = is(i + 2, "#");
        std::size_t at = i + 2;
        if (has_parameter_list_) at = closing(all_, at + 1) + 1;
        body_ = is(at, "(") ? closing(all_, at) : at;
        integers_.clear();
        generate_ = 0;
    }
    bool in_module_body(std::size_t i) const { return body_ > 0 && i > body_; }

    // ---- Lists of events ----

    struct Edge {
        bool rises;
        std::string_view signal;
    };

    void block(std::size_t i) {
        if (!is(i + 1, "@") || !is(i + 2, "(") || is(i + 3, "*") || is(i + 3, "*)")) return;
        const std::size_t end = closing(all_, i + 2);
        std::vector<Edge> edges;
        bool plain = false, known = true;
        for (std::size_t at = i + 3; at < end;) {
            const bool edge = is(at, "posedge") || is(at, "negedge");
            if (edge && at + 1 < end && is_plain_name(all_[at + 1]))
                edges.push_back({is(at, "posedge"), all_[at + 1].text});
            known &= !edge || (at + 1 < end && is_plain_name(all_[at + 1]) &&
                               (at + 2 >= end || is(at + 2, "or") || is(at + 2, ",")));
            plain |= !edge && all_[at].kind == Kind::NAME;
            while (at < end && !is(at, "or") && !is(at, ",")) ++at;
            ++at;
        }
        if (!edges.empty() && plain)
            error(10122, all_[i],
                  "the list has signals with an edge beside signals without; write posedge or "
                  "negedge at each");
        for (std::size_t a = 0; a < edges.size(); ++a)
            for (std::size_t b = a + 1; b < edges.size(); ++b)
                if (edges[a].signal == edges[b].signal && edges[a].rises != edges[b].rises)
                    error(10239, all_[i],
                          fmt::format("the list has both edges of {}; a register has one",
                                      edges[a].signal));
        if (known && edges.size() > 1 && !plain) asynchronous(end + 1, edges);
        if (!edges.empty()) mixed(end + 1);
    }

    // The first `if` of a block with several edges has to ask for one of them, at its level.
    void asynchronous(std::size_t i, const std::vector<Edge>& edges) {
        if (is(i, "begin") && is(i + 1, ":"))
            i += 3;
        else if (is(i, "begin"))
            ++i;
        if (!is(i, "if") || !is(i + 1, "(")) return;
        const std::size_t end = closing(all_, i + 1);
        const Edge* asked = nullptr;
        for (std::size_t at = i + 2; at < end; ++at) {
            if (all_[at].kind == Kind::MACRO) return;
            for (const Edge& edge : edges)
                if (all_[at].is(edge.signal)) asked = &edge;
        }
        const bool inverted = end == i + 4 && (is(i + 2, "!") || is(i + 2, "~"));
        const bool plain = end == i + 3;
        if (asked && (!inverted || !asked->rises) && (!plain || asked->rises)) return;
        error(10200, all_[i],
              asked ? fmt::format("the list has {} {}, so the `if` has to ask for {}{}",
                                  asked->rises ? "posedge" : "negedge", asked->signal,
                                  asked->rises ? "" : "!", asked->signal)
                    : std::string{"the list has several edges, but the first `if` asks for none of "
                                  "those signals; which is the reset?"});
    }

    void mixed(std::size_t i) {
        if (i >= all_.size()) return;
        try {
            const ClockedBlock block{all_, i};
            const ClockedBlock::Assignment* kinds[2]{};
            for (const auto& a : block.assignments()) {
                const auto& name = a.targets[0].name;
                if (block.loop_variables().count(name) || block.locals().count(name)) continue;
                kinds[a.is_blocking] = &a;
            }
            if (kinds[0] && kinds[1])
                warn(10268, all_[kinds[1]->begin],
                     "the block has both = and <=; all of them are registers, whose values come "
                     "from before the edge only with <=");
        } catch (const NotUnderstood&) {
        }
    }

    // ---- Words ----

    void system_task(const Token& token) {
        static const std::set<std::string_view> NAMES{"$monitor",  "$dumpfile", "$dumpvars",
                                                      "$fopen",    "$fclose",   "$fwrite",
                                                      "$fdisplay", "$strobe"};
        if (NAMES.count(token.text))
            warn(10175, token,
                 fmt::format("{} does nothing on the board; put it between translate_off and "
                             "translate_on",
                             token.text));
    }

    void literal(const Token& token) {
        const std::size_t quote = token.text.find('\'');
        if (quote == 0 || quote == std::string_view::npos || quote + 2 >= token.text.size()) return;
        const std::string digits = lower(std::string{token.text.substr(quote + 2)});
        if (digits == "z" || digits == "x" || digits == "?")
            if (token.text.substr(0, quote) != "1")
                warn(10273, token, fmt::format("{} is extended with {}", token.text, digits));
    }

    void parameter(std::size_t i) {
        if (has_parameter_list_ && in_module_body(i) && items_.begins_item(i))
            warn(10222, all_[i],
                 "the module has a list of parameters in its head, so this one cannot be set from "
                 "outside");
        // Without a range or a type it has the 32 bits of its value.
        if (is(i + 1, "[") || is(i + 1, "signed") || !is(i + 2, "=")) return;
        if (i + 3 < all_.size() && all_[i + 3].kind == Kind::NUMBER &&
            all_[i + 3].text.find('\'') == std::string_view::npos)
            integers_.insert(all_[i + 1].text);
    }
    void integers(std::size_t i) {
        for (std::size_t at = i + 1; at < all_.size() && is_plain_name(all_[at]); at += 2) {
            integers_.insert(all_[at].text);
            if (!is(at + 1, ",")) break;
        }
    }

    void registers(std::size_t i) {
        std::size_t at = i + 1;
        if (is(at, "signed")) ++at;
        while (is(at, "["))
            while (at < all_.size() && !is(at++, "]")) {
            }
        for (; at < all_.size() && is_plain_name(all_[at]); at += 2) {
            registers_.insert(all_[at].text);
            if (!is(at + 1, ",")) break;
        }
    }
    void assigned_registers() {
        for (const std::size_t i : assigns_)
            if (i + 1 < all_.size() && registers_.count(all_[i + 1].text) && !system_verilog_)
                error(
                    10219, all_[i],
                    fmt::format("{} is a reg, and is assigned by `assign`; declare it as wire, or "
                                "assign it in a block",
                                all_[i + 1].text));
        assigns_.clear();
        registers_.clear();
    }

    // At the "=" of "n[3:0] = m + 1;" or of "n <= m + 1;"
    void assignment(std::size_t i) {
        if (i < 2 || is(i + 1, "=") || is(i - 1, "=") || is(i - 1, "!") || is(i - 1, ">")) return;
        std::size_t at = i - 1;
        if (is(at, "<")) --at;
        while (at > 0 && is(at, "]")) {
            int depth = 0;
            do {
                depth += is(at, "]") - is(at, "[");
                --at;
            } while (depth > 0 && at > 0);
        }
        if (!is_plain_name(all_[at])) return;
        std::size_t end = i + 1;
        for (int depth = 0; end < all_.size(); ++end) {
            depth += is(end, "(") + is(end, "[") + is(end, "{");
            depth -= is(end, ")") + is(end, "]") + is(end, "}");
            if (depth < 0 || (depth == 0 && (is(end, ";") || is(end, ",")))) break;
        }
        if (Widths{all_, integers_}.is_wide(i + 1, end))
            checks_.of_32_bits.emplace(all_[i].line, std::string{all_[at].text});
    }

    const std::vector<Token>& all_;
    const Items& items_;
    const std::string& name_;
    const bool system_verilog_;
    bool has_parameter_list_ = false;
    std::size_t body_ = 0;
    unsigned generate_ = 0, conditions_ = 0;
    std::set<std::string_view> integers_, registers_;
    std::vector<std::size_t> assigns_;  // of the module
    TextChecks checks_;
};

}  // namespace

TextChecks check_text(const std::vector<Token>& tokens, const Items& items, const std::string& name,
                      bool system_verilog) {
    return TextChecker{tokens, items, name, system_verilog}.run();
}

}  // namespace sim::project
