#include "sim/verilog/part_drivers.h"

#include <algorithm>
#include <set>
#include <string_view>

#include <fmt/format.h>

namespace sim::project {

namespace {

using Kind = Token::Kind;

// Not where it is asked who drives what.
constexpr char ENABLE[] = "`ifdef DE1SIM_LISTS `else $c1(\"1\") ? `endif ";
constexpr char RELEASE[] = "`ifdef DE1SIM_LISTS `else : 'sbz `endif ";

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
                if (module_) find_released();
            } else if (!module_ || released_.empty()) {
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
    std::size_t find(std::size_t i, std::initializer_list<std::string_view> ends) const {
        return find_outside(tokens_, i, ends);
    }

    // Whether tokens up to `end` name a part of what is released, or join one with others.
    bool is_part(std::size_t begin, std::size_t end) const {
        const bool joined = tokens_[begin].is("{");
        for (std::size_t i = begin; i + 1 < end; ++i)
            if (tokens_[i].kind == Kind::NAME && (joined || tokens_[i + 1].is("[")) &&
                released_.count(tokens_[i].text))
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

    // Calls visit(begin, equals, end) for each assignment of the `assign` at `i`; its semicolon, or
    // the file's end.
    template <class Visit>
    std::size_t each_assignment(std::size_t i, Visit visit) const {
        std::size_t begin = i + 1;
        if (begin < tokens_.size() && tokens_[begin].is("#")) begin += 2;
        for (;;) {
            const std::size_t equals = find(begin, {"=", ";"}), end = find(equals, {",", ";"});
            if (end >= tokens_.size()) return end;
            if (tokens_[equals].is("=")) visit(begin, equals, end);
            if (tokens_[end].is(";")) return end;
            begin = end + 1;
        }
    }
    void assignments() {
        at_ = each_assignment(at_, [this](std::size_t begin, std::size_t equals, std::size_t end) {
            if (!is_part(begin, equals) || has_z(equals, end)) return;
            if (equals + 2 == end && released_.count(tokens_[equals + 1].text)) return;
            edits_.after[equals] += fmt::format(" {}(", ENABLE);
            edits_.before[end] += fmt::format("){}", RELEASE);
        });
    }

    // The module's inout ports, and what else an assign of it may release.
    void find_released() {
        released_.clear();
        for (const std::string& name : module_->inouts) released_.insert(name);
        for (std::size_t i = find(at_, {";"}); i < tokens_.size() && !tokens_[i].is("endmodule");
             ++i) {
            if (!tokens_[i].is("assign") && !tokens_[i].is("wire") && !tokens_[i].is("tri"))
                continue;
            i = each_assignment(i, [this](std::size_t begin, std::size_t equals, std::size_t end) {
                if (!has_z(equals, end)) return;
                for (int depth = 0; begin < equals; ++begin) {
                    depth += tokens_[begin].is("[") - tokens_[begin].is("]");
                    if (depth == 0 && tokens_[begin].kind == Kind::NAME)
                        released_.insert(tokens_[begin].text);
                }
            });
        }
    }

    // From the module's name on.
    void instances(const ModuleText& other) {
        const std::size_t statement = at_, end = find(at_, {";"});
        if (end >= tokens_.size()) return;
        std::string wires;
        for (const ConnectionText& c : connections_of(tokens_, at_, other))
            if (other.outputs.count(c.port) && is_part(c.first, c.last))
                wires += wire_for(c.first, c.last);
        at_ = end;
        if (wires.empty()) return;
        const Token& before = tokens_[statement - 1];
        const bool alone = before.is(")") || before.is("else");  // after an `if`
        edits_.before[statement] += (alone ? "begin " : "") + wires;
        if (alone) edits_.after[end] += " end";
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
            "assign {0}= {2}{1}{3}; ",
            part, wire, ENABLE, RELEASE);
    }

    const std::vector<Token>& tokens_;
    const Modules& modules_;
    Edits& edits_;
    const ModuleText* module_ = nullptr;
    std::set<std::string_view> released_;
    std::size_t at_ = 0;
    unsigned number_ = 0;
};

}  // namespace

void enable_part_drivers(const Tokens& tokens, const Modules& modules, Edits& edits) {
    PartDrivers{tokens.all, modules, edits}.run();
}

}  // namespace sim::project
