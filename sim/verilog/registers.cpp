#include "sim/verilog/registers.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "sim/verilog/clocked_block.h"

namespace sim::project {

namespace {

using Names = ClockedBlock::Names;

bool is_variable_type(const Token& token) {
    static const std::set<std::string_view> WORDS{"reg",  "logic",    "bit",     "integer", "int",
                                                  "byte", "shortint", "longint", "time"};
    return WORDS.count(token.text) > 0;
}

// The variables that a module declares, by name: "reg signed [7:0] "; empty: a memory, or several.
class Variables {
public:
    void begin_module() { types_.clear(); }

    // From the type's word on.
    void declare(const std::vector<Token>& all, std::size_t i) {
        const bool is_port = i > 0 && all[i - 1].is("output");
        std::string type{all[i++].text};
        for (; i < all.size() && (all[i].is("signed") || all[i].is("unsigned")); ++i)
            type += fmt::format(" {}", all[i].text);
        while (i < all.size() && all[i].is("["))
            for (bool inside = true; inside && i < all.size(); ++i) {
                type += fmt::format(" {}", all[i].text);
                inside = !all[i].is("]");
            }
        while (i + 1 < all.size() && all[i].kind == Token::Kind::NAME && !is_keyword(all[i].text) &&
               !is_variable_type(all[i])) {
            const std::string_view name = all[i].text;
            const bool again = types_.count(name) > 0;
            types_[name] = all[i + 1].is("[") || again ? "" : type + " ";
            if (is_port) ports_.insert(name);
            int depth = 0;
            for (++i; i < all.size(); ++i) {
                depth += all[i].is("(") + all[i].is("[") + all[i].is("{");
                depth -= all[i].is(")") + all[i].is("]") + all[i].is("}");
                if (depth < 0 || (depth == 0 && (all[i].is(",") || all[i].is(";")))) break;
            }
            if (i >= all.size() || !all[i].is(",")) return;
            ++i;
        }
    }
    void output(std::string_view name) { ports_.insert(name); }

    std::string type(std::string_view name) const {
        const auto found = types_.find(name);
        return found == types_.end() ? "" : found->second;
    }
    bool is_output(std::string_view name) const { return ports_.count(name) > 0; }

private:
    std::map<std::string_view, std::string> types_;
    Names ports_;
};

class Registers {
public:
    Registers(const std::vector<Token>& all, Edits& edits) : all_{all}, edits_{edits} {}

    void run() {
        for (std::size_t i = 0; i < all_.size(); ++i) {
            const Token& token = all_[i];
            if (token.is("module") || token.is("macromodule")) variables_ = {};
            if (token.is("endmodule")) end_of_module();
            if (token.is("always") || token.is("always_ff")) {
                i = process(i);
            } else if (is_variable_type(token)) {
                variables_.declare(all_, i);
            } else if (token.is("output")) {
                for (std::size_t n = i + 1; n < all_.size() && !all_[n].is(";") &&
                                            !all_[n].is(")") && !all_[n].is("input");
                     ++n)
                    variables_.output(all_[n].text);
            }
        }
        end_of_module();
    }

private:
    // After the block, where it is a clocked one that is understood.
    std::size_t process(std::size_t i) {
        if (i + 2 >= all_.size() || !all_[i + 1].is("@") || !all_[i + 2].is("(")) return i;
        std::size_t at = i + 3;
        bool clocked = false;
        for (int depth = 1; depth && at < all_.size(); ++at) {
            depth += all_[at].is("(") - all_[at].is(")");
            clocked |= all_[at].is("posedge") || all_[at].is("negedge");
        }
        if (!clocked || at >= all_.size()) return i;
        try {
            blocks_.emplace_back(all_, at);
            return blocks_.back().end() - 1;
        } catch (const NotUnderstood&) {
            return i;
        }
    }

    void end_of_module() {
        std::map<std::string_view, unsigned> users;  // how many blocks have it
        for (const ClockedBlock& block : blocks_) {
            Names names;
            for (std::size_t i = block.begin(); i < block.end(); ++i)
                if (all_[i].kind == Token::Kind::NAME) names.insert(all_[i].text);
            for (const auto name : names) ++users[name];
        }
        for (const ClockedBlock& block : blocks_) change(block, users);
        blocks_.clear();
    }

    // One "=" for several variables is that of a register only if all of them are.
    static Names kept_back(const ClockedBlock& block) {
        Names read = block.read_behind();
        for (std::size_t before = ~std::size_t{0}; before != read.size();) {
            before = read.size();
            for (const auto& a : block.assignments())
                if (a.is_blocking && std::any_of(a.targets.begin(), a.targets.end(),
                                                 [&](auto& t) { return read.count(t.name); }))
                    for (const auto& t : a.targets) read.insert(t.name);
        }
        return read;
    }

    void change(const ClockedBlock& block, const std::map<std::string_view, unsigned>& users) {
        const Names read = kept_back(block);
        Names copied, echoed, by_nonblocking;
        for (const auto& a : block.assignments())
            if (!a.is_blocking)
                for (const auto& t : a.targets) by_nonblocking.insert(t.name);
        for (const auto& a : block.assignments()) {
            if (!a.is_blocking) continue;
            if (a.is_plain && !read.count(a.targets[0].name) && !block.calls()) {
                edits_.before[a.sign] += "<";
                continue;
            }
            for (const auto& t : a.targets) {
                if (block.loop_variables().count(t.name) || block.locals().count(t.name)) continue;
                const bool mixed = by_nonblocking.count(t.name) > 0;
                const bool shared = users.at(t.name) > 1 || variables_.is_output(t.name);
                if (!variables_.type(t.name).empty() && (mixed || shared) && !block.calls())
                    copied.insert(t.name);
                else if (mixed)
                    echoed.insert(t.name);
            }
        }
        rename(block, copied);
        for (const auto& a : block.assignments()) echo(a, copied, echoed);
        if (!copied.empty()) declare(block, copied);
    }

    static std::string copy_of(std::string_view name) { return fmt::format("de1sim_d_{}", name); }

    void declare(const ClockedBlock& block, const Names& copied) {
        std::string open = fmt::format("begin : de1sim_block_{} ", ++number_);
        for (const auto name : copied) open += variables_.type(name) + copy_of(name) + "; ";
        for (const auto name : copied) open += fmt::format("{} = {}; ", copy_of(name), name);
        edits_.before[block.begin()].insert(0, open);
        edits_.after[block.end() - 1] += " end";
    }

    // All that the block reads and assigns by "=" of these is the copy.
    void rename(const ClockedBlock& block, const Names& copied) {
        std::set<std::size_t> kept;  // targets of "<="
        for (const auto& a : block.assignments())
            if (!a.is_blocking)
                for (const auto& t : a.targets) kept.insert(t.begin);
        for (std::size_t i = block.begin(); i < block.end(); ++i) {
            if (!copied.count(all_[i].text) || kept.count(i) || all_[i - 1].is(".")) continue;
            edits_.left_out.insert(i);
            edits_.before[i] += copy_of(all_[i].text);
        }
    }

    // After "n = d;" comes "n <= n;", or "n <= its copy;".
    void echo(const ClockedBlock::Assignment& a, const Names& copied, const Names& echoed) {
        std::string after;
        for (const auto& t : a.targets) {
            if (!a.is_blocking || (!copied.count(t.name) && !echoed.count(t.name))) continue;
            std::string select;
            for (std::size_t i = t.begin + 1; i < t.end; ++i)
                select += (copied.count(all_[i].text) && !all_[i - 1].is(".")
                               ? copy_of(all_[i].text)
                               : std::string{all_[i].text}) +
                          " ";
            after +=
                fmt::format(" {}{} <= {}{};", t.name, select,
                            copied.count(t.name) ? copy_of(t.name) : std::string{t.name}, select);
        }
        if (after.empty()) return;
        edits_.before[a.begin].insert(0, "begin ");
        edits_.after[a.end].insert(0, after + " end");
    }

    const std::vector<Token>& all_;
    Edits& edits_;
    Variables variables_;
    std::vector<ClockedBlock> blocks_;  // of this module
    unsigned number_ = 0;
};

}  // namespace

void make_registers(const Tokens& tokens, Edits& edits) { Registers{tokens.all, edits}.run(); }

}  // namespace sim::project
