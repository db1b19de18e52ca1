#include "sim/verilog/quartus/syntax.h"

#include <algorithm>
#include <set>
#include <string_view>

#include <fmt/format.h>

namespace sim::project {

namespace {

using Kind = Token::Kind;
using Words = std::set<std::string_view>;

const Words DIRECTIONS{"input", "output", "inout"};
const Words NETS{"wire", "tri", "wand", "wor", "tri0", "tri1"};
const Words TYPES{"logic", "bit", "byte", "shortint", "int", "longint"};
const Words REALS{"real", "realtime", "shortreal"};

// What is common to both languages' checks: the tokens, and where one is.
class Syntax {
public:
    Syntax(const std::vector<Token>& all, const Items& items, const std::string& name,
           TextChecks& found)
        : all_{all}, items_{items}, name_{name}, found_{found} {}

    void enter(std::string_view module) { module_ = module; }

    bool is(std::size_t i, std::string_view text) const {
        return i < all_.size() && all_[i].is(text);
    }
    bool is_one_of(std::size_t i, const Words& words) const {
        return i < all_.size() && words.count(all_[i].text) > 0;
    }
    bool is_name(std::size_t i) const {
        return i < all_.size() && all_[i].kind == Kind::NAME && !is_keyword(all_[i].text) &&
               all_[i].text[0] != '$';
    }
    bool touches(std::size_t i, std::string_view text) const {
        return is(i, text) && all_[i].gap.empty();
    }
    bool begins_item(std::size_t i) const { return i == 0 || items_.begins_item(i); }
    bool begins_statement(std::size_t i) const {
        static const Words BEFORE{";", "begin", ")", "*)", "else", "end", ":", "endcase"};
        return i > 0 && BEFORE.count(all_[i - 1].text) > 0;
    }
    // After the brackets that begin at `i`, if some do.
    std::size_t behind_range(std::size_t i) const {
        if (!is(i, "[")) return i;
        for (int depth = 0; i < all_.size(); ++i) {
            depth += is(i, "[") - is(i, "]");
            if (depth == 0) return i + 1;
        }
        return i;
    }

    void refuse(unsigned number, std::size_t i, std::string text) {
        found_.errors.push_back({number, name_, all_[i].line, std::move(text)});
    }
    void warn(unsigned number, std::size_t i, std::string text) {
        found_.warnings.push_back({number, name_, all_[i].line, std::move(text)});
    }
    void refuse_in_design(unsigned number, std::size_t i, std::string text) {
        report_in_design(true, number, i, std::move(text));
    }
    void report_in_design(bool is_error, unsigned number, std::size_t i, std::string text) {
        found_.of_modules.push_back(
            {module_, is_error, {number, name_, all_[i].line, std::move(text)}});
    }
    void near(std::size_t i, const std::string& why) {
        refuse(10170, i, fmt::format("syntax error near \"{}\"; {}", all_[i].text, why));
    }

    const std::vector<Token>& all_;
    const Items& items_;

private:
    const std::string& name_;
    std::string module_;
    TextChecks& found_;
};

// What a .v file has no words for.
class Verilog2001 {
public:
    explicit Verilog2001(Syntax& syntax) : s_{syntax} {}

    void look(std::size_t i) {
        word(i);
        operators(i);
        declaration(i);
        connection(i);
    }

private:
    void is_new(std::size_t i) {
        s_.near(i, "this is SystemVerilog: name the file .sv, and a SYSTEMVERILOG_FILE");
    }

    void word(std::size_t i) {
        static const Words BLOCKS{"always_ff", "always_comb", "always_latch"};
        static const Words ITEMS{"typedef",   "enum",    "struct", "import",
                                 "interface", "package", "class",  "modport"};
        static const Words CHOICES{"case", "casex", "casez", "if"};
        static const Words LABELLED{"end", "endmodule", "endfunction", "endtask", "endpackage"};
        const bool types =
            s_.is_one_of(i, TYPES) && (s_.is_name(i + 1) || s_.is(i + 1, "[")) &&
            (s_.begins_item(i) || s_.is_one_of(i - 1, DIRECTIONS) || s_.is(i - 1, "parameter") ||
             s_.is(i - 1, "localparam") || (s_.begins_statement(i) && s_.is_name(i + 1)));
        const bool item = s_.is_one_of(i, ITEMS) && s_.begins_item(i) &&
                          (s_.is_name(i + 1) || s_.is(i + 1, "{") || s_.is(i + 1, "reg"));
        const bool ends = (s_.is(i, "break") || s_.is(i, "continue")) && s_.is(i + 1, ";");
        const bool returns = s_.is(i, "return") && s_.begins_statement(i) && !s_.is(i + 1, "=") &&
                             !s_.is(i + 1, "<") && !s_.is(i + 1, "[") && !s_.is(i + 1, "(");
        const bool chooses =
            (s_.is(i, "unique") || s_.is(i, "priority")) && s_.is_one_of(i + 1, CHOICES);
        const bool label = s_.is_one_of(i, LABELLED) && s_.is(i + 1, ":");
        const bool block = s_.is_one_of(i, BLOCKS) &&
                           (s_.is(i + 1, "@") || s_.is(i + 1, "begin") || s_.is(i + 1, "if") ||
                            s_.is(i + 1, "case") || s_.is_name(i + 1));
        const bool loops = s_.is(i, "foreach") && s_.is(i + 1, "(");
        if (types || item || ends || returns || chooses || block || loops) is_new(i);
        if (label) is_new(i + 1);
        if (s_.is(i, "function") && (s_.is(i + 1, "void") || s_.is(i + 2, "void"))) is_new(i + 1);
        if (s_.is(i, "for") && s_.is(i + 1, "(") &&
            (s_.is_one_of(i + 2, TYPES) || s_.is(i + 2, "integer") || s_.is(i + 2, "genvar")))
            is_new(i + 2);
        if (s_.is(i, "inside") && s_.is(i + 1, "{")) is_new(i);
    }

    void operators(std::size_t i) {
        static const Words SIGNS{"+", "-", "*", "/", "%", "&", "|", "^"};
        const bool twice =
            (s_.is(i, "+") && s_.touches(i + 1, "+")) || (s_.is(i, "-") && s_.touches(i + 1, "-"));
        if (twice && (s_.is(i + 2, ";") || s_.is(i + 2, ")"))) is_new(i);
        if (s_.is_one_of(i, SIGNS) && s_.touches(i + 1, "=") && !s_.touches(i + 2, "=") &&
            (s_.is_name(i - 1) || s_.is(i - 1, "]")))
            is_new(i);
        const bool shifts =
            (s_.is(i, "<") && s_.touches(i + 1, "<")) || (s_.is(i, ">") && s_.touches(i + 1, ">"));
        if (shifts && s_.touches(i + 2, "=")) is_new(i);
        if (s_.is(i, "'") && i + 1 < s_.all_.size() && s_.all_[i + 1].gap.empty()) {
            static const Words BEHIND{"0", "1", "x", "z", "X", "Z", "{", "("};
            if (s_.is_one_of(i + 1, BEHIND)) is_new(i);
        }
    }

    void declaration(std::size_t i) {
        const bool port = s_.is_one_of(i, DIRECTIONS);
        if (!port && !s_.is(i, "reg") && !s_.is_one_of(i, NETS)) return;
        std::size_t at = i + 1;
        if (port && s_.is(at, "reg") && s_.is(i, "input"))
            s_.refuse(10278, at, "an input cannot be a reg; leave reg out");
        while (s_.is(at, "reg") || s_.is_one_of(at, NETS) || s_.is(at, "signed")) ++at;
        at = s_.behind_range(at);
        if (s_.is(at, "[")) return is_new(at);
        while (s_.is_name(at)) {
            const std::size_t after = s_.behind_range(at + 1);
            if (after > at + 1 && port)
                s_.refuse(10773, at,
                          fmt::format("port {} is an array, which a .v file cannot have",
                                      s_.all_[at].text));
            if (after == at + 4 && s_.all_[at + 2].kind == Kind::NUMBER) is_new(at + 3);
            at = after;
            if (!s_.is(at, ",")) break;
            ++at;
        }
    }

    // .clk, and .* of an instance
    void connection(std::size_t i) {
        if (!s_.is(i, ".") || !(s_.is(i - 1, "(") || s_.is(i - 1, ","))) return;
        if (s_.is(i + 1, "*)") || s_.is(i + 1, "*") ||
            (s_.is_name(i + 1) && (s_.is(i + 2, ",") || s_.is(i + 2, ")"))))
            is_new(i);
    }

    Syntax& s_;
};

// What Quartus' SystemVerilog has not.
class LessSystemVerilog {
public:
    explicit LessSystemVerilog(Syntax& syntax) : s_{syntax} {}

    void look(std::size_t i) {
        if (s_.is(i, "inside") && s_.is(i + 1, "{"))
            s_.near(i, "Quartus has no `inside`; write the comparisons");
        const bool left = s_.is(i + 1, "<") && s_.touches(i + 2, "<"),
                   right = s_.is(i + 1, ">") && s_.touches(i + 2, ">");
        if (s_.is(i, "{") && (left || right))
            s_.near(i + 1, "Quartus has no streaming operator; write a loop");
        if (s_.is(i, "type") && (s_.is(i - 1, "parameter") || s_.is(i - 1, "localparam")) &&
            s_.is_name(i + 1))
            s_.near(i, "Quartus has no parameters that are types; write the width as one");
        if (s_.is(i, "class") && s_.begins_item(i) && s_.is_name(i + 1))
            s_.refuse_in_design(0, i, "Quartus has no classes");
        if (s_.is(i, "enum")) enumeration(i);
    }

private:
    void enumeration(std::size_t i) {
        std::size_t at = i + 1;
        if (!s_.is(at, "logic") && !s_.is(at, "bit") && !s_.is(at, "reg")) return;
        ++at;
        const std::size_t open = s_.behind_range(at);
        if (!s_.is(open, "{")) return;
        for (at = open + 1; at < s_.all_.size() && !s_.is(at, "}"); ++at) {
            const Token& value = s_.all_[at];
            const bool whole = s_.is(at - 1, "=") && (s_.is(at + 1, ",") || s_.is(at + 1, "}"));
            if (!whole || value.kind != Kind::NUMBER || value.text.find('\'') != value.text.npos)
                continue;
            return s_.refuse_in_design(
                10355, at - 2,
                fmt::format("the value of {} has no size, so it has 32 bits, which are not those "
                            "of the enumeration; write it with its size",
                            s_.all_[at - 2].text));
        }
    }

    Syntax& s_;
};

// What neither has.
class NoHardware {
public:
    NoHardware(Syntax& syntax, bool system_verilog)
        : s_{syntax}, is_system_verilog_{system_verilog} {}

    void look(std::size_t i) {
        depth_ += s_.is(i, "(") || s_.is(i, "[") || s_.is(i, "{");
        const bool ends_list = s_.is(i, "*)") && s_.is(i - 1, "(");  // @(*)
        const bool ends_stars = s_.is(i, ")") && s_.is(i - 1, "(*");
        depth_ -= (s_.is(i, ")") && !ends_stars) || ends_list || s_.is(i, "]") || s_.is(i, "}");
        if (s_.is(i, "module") || s_.is(i, "macromodule")) header(i);
        if (s_.is(i, ";") && depth_ == 0 && i > 0 &&
            (s_.begins_item(i) || s_.is(i - 1, "endmodule")))
            s_.near(i, "there is nothing before it; leave it out");
        if (s_.is_one_of(i, REALS) && !s_.is(i - 1, "parameter") && !s_.is(i - 1, "localparam") &&
            s_.is_name(i + 1))
            s_.refuse_in_design(10172, i,
                                "real variables are for simulation alone; count in integers");
        static const Words DICE{"$random", "$urandom", "$urandom_range"};
        if (s_.is_one_of(i, DICE))
            s_.refuse_in_design(
                10174, i,
                fmt::format("{} is for simulation alone; a counter or a shift register with "
                            "feedback makes numbers on the board",
                            s_.all_[i].text));
        statement(i);
        if (s_.is(i, "for") && depth_ == 0 && s_.begins_item(i) && s_.is(i + 1, "(")) {
            const std::size_t after = closing(s_.all_, i + 1) + 1;
            if (s_.is(after, "begin") && !s_.is(after + 1, ":"))
                s_.refuse(10644, after, "the block of a generate loop needs a name: begin : NAME");
        }
        if (s_.is(i, "begin")) block(i);
        if ((s_.is(i, "reg") || s_.is_one_of(i, NETS)) && s_.begins_item(i)) redeclaration(i + 1);
    }

private:
    void header(std::size_t i) {
        ports_.clear();
        std::size_t open = i + 2;
        if (s_.is(open, "#")) open = closing(s_.all_, open + 1) + 1;
        if (!s_.is(open, "(")) return;
        const std::size_t close = closing(s_.all_, open);
        bool directions = false;
        for (std::size_t at = open + 1; at < close; ++at) {
            directions |= s_.is_one_of(at, DIRECTIONS);
            if (directions && s_.is_name(at) && (s_.is(at + 1, ",") || at + 1 == close))
                ports_.insert(s_.all_[at].text);
        }
        if (directions && s_.is(close - 1, ","))
            s_.near(close, "a port is expected after the comma; leave the comma out");
    }

    void redeclaration(std::size_t at) {
        while (s_.is(at, "signed") || s_.is(at, "reg")) ++at;
        at = s_.behind_range(at);
        for (; s_.is_name(at); at += 2) {
            if (ports_.count(s_.all_[at].text))
                s_.refuse(10149, at,
                          fmt::format("{} is declared in the module's head; write `output reg` "
                                      "there, and leave this out",
                                      s_.all_[at].text));
            if (!s_.is(at + 1, ",")) break;
        }
    }

    void statement(std::size_t i) {
        static const Words BLOCKS{"always", "always_ff", "always_latch", "always_comb"};
        if (s_.is(i, "always") && !s_.is(i + 1, "@")) free_running(i);
        if (i < without_event_) return;
        if (s_.is(i, "@") && depth_ == 0 && !s_.is_one_of(i - 1, BLOCKS))
            s_.refuse_in_design(
                0, i,
                "an event control inside a block cannot be built; there is one alone, at the "
                "beginning of an always");
        if (s_.is(i, "wait") && s_.is(i + 1, "(") && s_.begins_statement(i))
            s_.refuse_in_design(0, i, "wait cannot be built; ask at each clock with `if`");
        if (s_.is(i, "fork") && (s_.begins_statement(i) || s_.begins_item(i)))
            s_.refuse_in_design(
                0, i, "fork cannot be built; <= between begin and end happens at once, too");
    }

    // Without a list of events it is logic, and Quartus ignores delays.
    void free_running(std::size_t i) {
        const std::size_t end = behind_statement(s_.all_, i + 1);
        const auto has = [&](std::string_view sign) {
            std::size_t at = i + 1;
            while (at < end && !s_.is(at, sign)) ++at;
            return at < end;
        };
        const bool waits = has("@");
        if (waits) without_event_ = end;
        if (waits || has("#"))
            s_.report_in_design(
                waits, 0, i,
                "always needs a list of events, as in @(posedge CLOCK_50) or @(*), and no other "
                "inside; delays are nothing on the board, where a counter divides a clock");
    }

    // What is declared in a block of statements needs the block's name.
    void block(std::size_t i) {
        static const Words DECLARATIONS{"reg", "integer", "time"};
        if (!s_.items_.is_statement(i) || !s_.is_one_of(i + 1, DECLARATIONS)) return;
        if (is_system_verilog_) return;
        s_.warn(10644, i,
                fmt::format("a block with a declaration ({}) needs a name in Verilog-2001: "
                            "begin : NAME",
                            s_.all_[i + 1].text));
    }

    Syntax& s_;
    const bool is_system_verilog_;
    int depth_ = 0;
    std::size_t without_event_ = 0;     // up to there goes a block without an event
    std::set<std::string_view> ports_;  // with a direction in the module's head
};

}  // namespace

void find_syntax_errors(const std::vector<Token>& tokens, const Items& items,
                        const std::string& name, bool system_verilog, TextChecks& found) {
    Syntax syntax{tokens, items, name, found};
    Verilog2001 verilog{syntax};
    LessSystemVerilog less{syntax};
    NoHardware none{syntax, system_verilog};
    unsigned conditions = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        follow_conditions(tokens[i].gap, conditions);
        if (tokens[i].is("module") && i + 1 < tokens.size()) syntax.enter(tokens[i + 1].text);
        if (conditions) continue;
        none.look(i);
        if (system_verilog)
            less.look(i);
        else
            verilog.look(i);
    }
}

}  // namespace sim::project
