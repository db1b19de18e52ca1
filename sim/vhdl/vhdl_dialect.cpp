#include "sim/vhdl/vhdl_dialect.h"

#include <set>
#include <vector>

#include "sim/text/lower.h"
#include "sim/verilog/edits.h"
#include "sim/verilog/synthesised.h"
#include "sim/vhdl/vhdl_tokens.h"

namespace sim::project {

namespace {

const std::string MARK = "_de1sim93";  // after a name that is a word of VHDL-2008

// The comments of a gap are read, or order what is read from there on.
class Directives {
public:
    std::string run(const std::string& text) {
        const Tokens tokens = vhdl_tokens(text);
        std::string result;
        for (const Token& token : tokens.all) {
            result += read(token.gap);
            result += off_ ? std::string(token.text.size(), ' ') : std::string{token.text};
        }
        return result + read(tokens.tail);
    }

private:
    std::string read(std::string_view gap) {
        std::string result{gap};
        for (std::size_t at = 0; at < gap.size();) {
            const bool is_line = gap.compare(at, 2, "--") == 0;
            if (!is_line && gap.compare(at, 2, "/*") != 0) {
                ++at;
                continue;
            }
            const std::size_t end = std::min(gap.find(is_line ? "\n" : "*/", at + 2), gap.size());
            const std::string order = order_in(gap.substr(at + 2, end - at - 2));
            if (order == "translate_off") off_ = true;
            if (order == "translate_on") off_ = false;
            if (order == "read_comments_as_hdl on") comments_are_read_ = true;
            if (order == "read_comments_as_hdl off") comments_are_read_ = false;
            if (order.empty() && is_line && comments_are_read_ && !off_)
                result.replace(at, 2, "  ");
            at = end + (is_line ? 0 : 2);
        }
        return result;
    }

    bool off_ = false, comments_are_read_ = false;
};

bool is_word_of_2008(const std::string& low) {
    static const std::set<std::string> WORDS{
        "assume",   "assume_guarantee", "context",  "cover",   "default",  "fairness",
        "force",    "parameter",        "property", "release", "restrict", "restrict_guarantee",
        "sequence", "strong",           "vmode",    "vprop",   "vunit"};
    return WORDS.count(low) > 0;
}

class Dialect {
public:
    explicit Dialect(const std::string& text)
        : tokens_{vhdl_tokens(text)}, low_{in_lower_case(tokens_.all)} {}

    std::string run() {
        for (std::size_t i = 0; i < low_.size(); ++i) {
            if (is_word_of_2008(low_[i]) && !is_in_2008(i)) edits_.after[i] += MARK;
            if (is(i, "wait") && is(i + 1, "until")) wait_until(i + 2);
        }
        return changed_text(tokens_, edits_);
    }

private:
    bool is(std::size_t i, std::string_view what) const {
        return i < low_.size() && low_[i] == what;
    }
    bool is_name(std::size_t i) const {
        return i < low_.size() && tokens_.all[i].kind == Token::Kind::NAME;
    }

    // "context work.words;", "end context;", "function f parameter (" are of VHDL-2008.
    bool is_in_2008(std::size_t i) const {
        if (is(i, "context"))
            return ((i == 0 || is(i - 1, ";")) && is_name(i + 1)) || (i > 0 && is(i - 1, "end"));
        return is(i, "parameter") && i > 1 && (is(i - 2, "function") || is(i - 2, "procedure"));
    }

    // NAME = '1' ; also in parentheses
    void wait_until(std::size_t i) {
        std::size_t open = 0;
        while (is(i, "(")) ++i, ++open;
        const std::size_t name = i++;
        if (!is_name(name) || !is(i++, "=") || !(is(i, "'1'") || is(i, "'0'"))) return;
        for (++i; open > 0 && is(i, ")"); ++i) --open;
        if (open == 0 && is(i, ";")) edits_.before[name] += low_[name] + "'event and ";
    }

    const Tokens tokens_;
    const std::vector<std::string> low_;
    Edits edits_;
};

}  // namespace

std::string as_ghdl_takes_it(const std::string& text) {
    const std::string read = Directives{}.run(text);
    return Dialect{read}.run();
}

std::string name_for_ghdl(const std::string& name) {
    return is_word_of_2008(lower(name)) ? name + MARK : name;
}

std::string with_own_names(std::string text) {
    for (std::size_t at = 0; (at = text.find(MARK, at)) != std::string::npos;)
        text.erase(at, MARK.size());
    return text;
}

}  // namespace sim::project
