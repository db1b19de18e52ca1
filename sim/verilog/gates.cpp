#include "sim/verilog/gates.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "sim/verilog/edits.h"
#include "sim/verilog/items.h"
#include "sim/verilog/tokens.h"

namespace sim::project {

namespace {

using Kind = Token::Kind;

bool is_one_of(const Token& token, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), token.text) != words.end();
}
bool is_tri_state(const Token& token) {
    return is_one_of(token, {"bufif0", "bufif1", "notif0", "notif1"});
}
bool is_gate(const Token& token) {
    return is_one_of(token, {"and", "nand", "or", "nor", "xor", "xnor", "buf", "not"});
}

class Gates {
public:
    Gates(const std::vector<Token>& all, const Modules& modules)
        : all_{all}, items_{all}, modules_{modules} {}

    const Edits& run() {
        for (std::size_t i = 0; i < all_.size(); ++i) {
            if (all_[i].is("module")) nets_ = wired_nets(i);
            if (all_[i].is("endmodule")) join_drivers(i);
            if (!items_.begins_item(i)) continue;
            if (is_tri_state(all_[i]))
                i = tri_states(i);
            else if (!nets_.empty())
                add_drivers(i);
        }
        return edits_;
    }

private:
    struct Net {
        std::string_view kind;  // wand, wor
        std::string range;      // "[3:0]", or empty
        std::vector<std::string> drivers;
    };
    using Nets = std::map<std::string, Net, std::less<>>;

    bool is(std::size_t i, std::string_view text) const {
        return i < all_.size() && all_[i].is(text);
    }
    std::string text(std::size_t begin, std::size_t end) const {
        return text_between(all_, begin, end);
    }

    // ---- Tri-state gates ----
    // The statement's last token; it stays as it is where there is an array of them.
    std::size_t tri_states(std::size_t i) {
        const std::size_t end = find_outside(all_, i, {";"});
        const bool inverts = all_[i].text[0] == 'n', low = all_[i].text.back() == '0';
        std::size_t at = i + 1;
        if (is(at, "(") && is_strength(at + 1)) at = closing(all_, at) + 1;
        if (is(at, "#")) at = is(at + 1, "(") ? closing(all_, at + 1) + 1 : at + 2;
        std::string assignments;
        while (at < end) {
            if (all_[at].kind == Kind::NAME) ++at;
            if (!is(at, "(")) return end;
            const std::size_t close = closing(all_, at), to = find_outside(all_, at + 1, {","}),
                              from = find_outside(all_, to + 1, {","});
            if (from >= close || close > end) return end;
            const std::string data = fmt::format("{}({})", inverts ? "~" : "", text(to + 1, from));
            assignments += fmt::format(
                "{} {} = ({}) ? {} : {}", assignments.empty() ? "assign" : ",", text(at + 1, to),
                text(from + 1, close), low ? "1'bz" : data, low ? data : "1'bz");
            at = close + 1 + is(close + 1, ",");
        }
        for (std::size_t k = i; k < end && k < all_.size(); ++k) edits_.left_out.insert(k);
        edits_.before[i] = assignments;
        return end;
    }
    bool is_strength(std::size_t i) const {
        return i < all_.size() &&
               is_one_of(all_[i], {"supply0", "supply1", "strong0", "strong1", "pull0", "pull1",
                                   "weak0", "weak1", "highz0", "highz1"});
    }

    // ---- Wired nets ----
    Nets wired_nets(std::size_t module) {
        Nets nets;
        const auto here = modules_.find(module + 1 < all_.size() ? all_[module + 1].text : "");
        for (std::size_t i = module; i < all_.size() && !all_[i].is("endmodule"); ++i) {
            if (!is_one_of(all_[i], {"wand", "wor"}) || !items_.begins_item(i)) continue;
            std::size_t at = i + 1;
            if (is(at, "signed")) ++at;
            std::size_t open = at;
            while (is(at, "[")) at = find_outside(all_, at + 1, {"]"}) + 1;
            const Net net{all_[i].text, text(open, at), {}};
            const std::size_t end = find_outside(all_, at, {";"});
            bool all_plain = end < all_.size();
            for (std::size_t k = at; k < end && all_plain; k += 2)
                all_plain = all_[k].kind == Kind::NAME && (is(k + 1, ",") || k + 1 == end) &&
                            (here == modules_.end() ||
                             std::find(here->second.ports.begin(), here->second.ports.end(),
                                       all_[k].text) == here->second.ports.end());
            if (!all_plain) continue;
            for (std::size_t k = at; k < end; k += 2) nets.emplace(all_[k].text, net);
            edits_.left_out.insert(i);
            edits_.before[i] = "wire";
        }
        return nets;
    }
    // A net of its own in the place of the one that token `i` drives, declared before `item`.
    void add_driver(std::size_t item, std::size_t i, std::size_t end) {
        if (i >= all_.size()) return;
        const auto net = nets_.find(all_[i].text);
        if (net == nets_.end()) return;
        std::vector<std::string>& drivers = net->second.drivers;
        std::string own = fmt::format("{}_de1sim_{}", net->first, drivers.size());
        edits_.before[item] += fmt::format("wire {} {}; ", net->second.range, own);
        edits_.left_out.insert(i);
        edits_.before[i] += own;
        // The bits that an assignment leaves open are 0, and so 1 for the "and" if it is inverted.
        const std::size_t equals = find_outside(all_, i, {"="});
        if (net->second.kind == "wand" && is(i + 1, "[") && equals < end) {
            edits_.after[equals] += "~(";
            edits_.after[end - 1] += ")";
            own = "~" + own;
        }
        drivers.push_back(own);
    }
    void add_drivers(std::size_t i) {
        const std::size_t end = find_outside(all_, i, {";"});
        if (all_[i].is("assign")) {
            for (std::size_t at = i + 1; at < end;) {
                const std::size_t to = find_outside(all_, at, {",", ";"});
                add_driver(i, at, to);
                at = to + 1;
            }
        } else if (is_gate(all_[i])) {
            for (std::size_t open = find_outside(all_, i, {"(", ";"}); open < end;
                 open = find_outside(all_, closing(all_, open) + 1, {"(", ";"}))
                add_driver(i, open + 1, open + 1);
        } else if (const auto module = modules_.find(all_[i].text); module != modules_.end()) {
            for (const ConnectionText& c : connections_of(all_, i, module->second))
                if (module->second.outputs.count(c.port)) add_driver(i, c.first, c.first);
        }
    }
    void join_drivers(std::size_t end) {
        for (const auto& [name, net] : nets_) {
            if (net.drivers.empty()) continue;
            edits_.before[end] +=
                fmt::format("assign {} = {}; ", name,
                            fmt::join(net.drivers, net.kind == "wand" ? " & " : " | "));
        }
        nets_.clear();
    }

    const std::vector<Token>& all_;
    const Items items_;
    const Modules& modules_;
    Nets nets_;  // of the module
    Edits edits_;
};

}  // namespace

std::string gates_as_assignments(std::string_view text, const Modules& modules) {
    const Tokens tokens = tokens_of(text);
    const std::vector<Token>& all = tokens.all;
    if (std::none_of(all.begin(), all.end(), [](const Token& t) {
            return is_tri_state(t) || is_one_of(t, {"wand", "wor"});
        }))
        return std::string{text};
    Gates gates{all, modules};
    return changed_text(tokens, gates.run());
}

}  // namespace sim::project
