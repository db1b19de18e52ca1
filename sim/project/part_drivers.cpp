#include "sim/project/part_drivers.h"

#include <algorithm>

#include <fmt/format.h>

namespace sim::project {

namespace {

using Kind = Token::Kind;

class PartDrivers {
public:
    PartDrivers(const std::vector<Token>& tokens, const Modules& modules, Edits& edits)
        : tokens_{tokens}, modules_{modules}, edits_{edits} {}

    void run() {
        for (at_ = 0; at_ + 1 < tokens_.size(); ++at_) {
            const Token& token = tokens_[at_];
            if (token.is("module") || token.is("macromodule")) {
                const auto here = modules_.find(tokens_[at_ + 1].text);
                module_ = here == modules_.end() ? nullptr : &here->second;
                ++at_;
            } else if (!module_ || module_->inouts.empty()) {
                continue;
            } else if (token.is("assign")) {
                assignments();
            } else if (const auto other = modules_.find(token.text);
                       other != modules_.end() && token.kind == Kind::NAME) {
                instances(other->second);
            }
        }
    }

private:
    // The first of `ends` from `i` on that is not in parentheses of any kind, or the file's end.
    std::size_t find(std::size_t i, std::initializer_list<std::string_view> ends) const {
        for (int depth = 0; i < tokens_.size(); ++i) {
            const Token& token = tokens_[i];
            if (depth == 0 && std::find(ends.begin(), ends.end(), token.text) != ends.end()) break;
            depth += token.is("(") || token.is("[") || token.is("{");
            depth -= token.is(")") || token.is("]") || token.is("}");
        }
        return i;
    }

    // Whether tokens up to `end` name a part of an inout port, or join one with others.
    bool is_part(std::size_t begin, std::size_t end) const {
        const bool joined = tokens_[begin].is("{");
        for (std::size_t i = begin; i + 1 < end; ++i)
            if (tokens_[i].kind == Kind::NAME && (joined || tokens_[i + 1].is("[")) &&
                module_->inouts.count(std::string{tokens_[i].text}))
                return true;
        return false;
    }
    bool has_z(std::size_t begin, std::size_t end) const {
        return std::any_of(tokens_.begin() + static_cast<std::ptrdiff_t>(begin),
                           tokens_.begin() + static_cast<std::ptrdiff_t>(end), [](const Token& t) {
                               return t.kind == Kind::NUMBER &&
                                      t.text.find_first_of("zZ?") != std::string_view::npos;
                           });
    }

    // From `assign` on, to its semicolon.
    void assignments() {
        std::size_t begin = at_ + 1;
        if (begin < tokens_.size() && tokens_[begin].is("#")) begin += 2;
        for (;;) {
            const std::size_t equals = find(begin, {"=", ";"}), end = find(equals, {",", ";"});
            if (end >= tokens_.size()) return;
            if (tokens_[equals].is("=") && is_part(begin, equals) && !has_z(equals, end)) {
                edits_.behind[equals] += " $c1(\"1\") ? (";
                edits_.before[end] += ") : 'sbz";
            }
            at_ = end;
            if (tokens_[end].is(";")) return;
            begin = end + 1;
        }
    }

    // From the module's name on: [#(...)] NAME [range] ( connections ), ... ;
    void instances(const ModuleText& other) {
        const std::size_t statement = at_, end = find(at_, {";"});
        if (end >= tokens_.size()) return;
        std::string wires;
        for (std::size_t open = find(at_ + 1, {"(", ";"}); open < end;
             open = find(open + 1, {"(", ";"})) {
            const std::size_t close = find(open + 1, {")"});
            if (!tokens_[open - 1].is("#")) connections(other, open, close, wires);
            open = close;
        }
        at_ = end;
        if (wires.empty()) return;
        const Token& before = tokens_[statement - 1];
        const bool alone = before.is(")") || before.is("else");  // behind an `if`
        edits_.before[statement] += (alone ? "begin " : "") + wires;
        if (alone) edits_.behind[end] += " end";
    }

    void connections(const ModuleText& other, std::size_t open, std::size_t close,
                     std::string& wires) {
        std::size_t position = 0;
        for (std::size_t i = open + 1; i < close; ++position) {
            const std::size_t end = find(i, {",", ")"});
            std::size_t first = i, last = end;
            std::string port;
            if (tokens_[i].is(".") && i + 3 < end && tokens_[i + 2].is("(")) {
                port = tokens_[i + 1].text;
                first = i + 3;
                last = end - 1;
            } else if (position < other.header.size()) {
                port = other.header[position];
            }
            if (first < last && other.outputs.count(port) && is_part(first, last))
                wires += wire_for(first, last);
            i = end + 1;
        }
    }

    // Puts a wire in the place of the part of tokens up to `end`; the text that declares it.
    std::string wire_for(std::size_t begin, std::size_t end) {
        std::string part;
        for (std::size_t i = begin; i < end; ++i) {
            part += std::string{tokens_[i].text} + " ";
            edits_.left_out.insert(i);
        }
        const std::string wire = fmt::format("de1sim_part_{}", ++number_);
        edits_.before[begin] += wire;
        return fmt::format(
            "`begin_keywords \"1800-2017\" wire [$bits({0})-1:0] {1}; `end_keywords "
            "assign {0}= $c1(\"1\") ? {1} : 'sbz; ",
            part, wire);
    }

    const std::vector<Token>& tokens_;
    const Modules& modules_;
    Edits& edits_;
    const ModuleText* module_ = nullptr;
    std::size_t at_ = 0;
    unsigned number_ = 0;
};

}  // namespace

void enable_part_drivers(const Tokens& tokens, const Modules& modules, Edits& edits) {
    PartDrivers{tokens.all, modules, edits}.run();
}

}  // namespace sim::project
