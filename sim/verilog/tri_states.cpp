#include "sim/verilog/tri_states.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace sim::project {

namespace {

using Kind = Token::Kind;

class TriStates {
public:
    TriStates(const std::vector<Token>& all, const Modules& modules, Edits& edits)
        : all_{all}, modules_{modules}, edits_{edits} {}

    Messages run() {
        for (std::size_t i = 0; i + 1 < all_.size(); ++i)
            if (all_[i].is("module")) i = module(i);
        return std::move(messages_);
    }

private:
    struct Buffer {
        std::size_t equals, question, colon, end;
        bool second_is_z;
    };

    bool is(std::size_t i, std::string_view text) const {
        return i < all_.size() && all_[i].is(text);
    }

    // Its last token.
    std::size_t module(std::size_t begin) {
        const auto here = modules_.find(all_[begin + 1].text);
        std::size_t end = begin;
        while (end < all_.size() && !all_[end].is("endmodule")) ++end;
        if (here == modules_.end()) return end;
        buffers_.clear();
        passed_over_.clear();
        for (const std::string& port : here->second.ports) passed_over_.insert(port);
        for (std::size_t i = find_outside(all_, begin + 2, {";"}); i < end; ++i) {
            if (all_[i].is("assign"))
                i = assignments(i + 1);
            else if (all_[i].is("wire") || all_[i].is("tri"))
                i = declarations(i + 1);
            else if (all_[i].kind == Kind::NAME && i + 1 < end && all_[i + 1].kind == Kind::NAME)
                instance(i);
        }
        for (const auto& [name, buffer] : buffers_)
            if (!passed_over_.count(name)) make_wire(name, buffer);
        return end;
    }

    std::size_t assignments(std::size_t i) {
        for (;;) {
            const std::size_t equals = find_outside(all_, i, {"=", ";"}),
                              end = find_outside(all_, equals, {",", ";"});
            if (end >= all_.size()) return end;
            if (equals < end) assignment(i, equals, end);
            if (all_[end].is(";")) return end;
            i = end + 1;
        }
    }
    // wire [3:0] a = on ? b : 4'bz, c;
    std::size_t declarations(std::size_t i) {
        while (is(i, "[")) i = find_outside(all_, i + 1, {"]"}) + 1;
        return assignments(i);
    }

    void assignment(std::size_t begin, std::size_t equals, std::size_t end) {
        const Token& target = all_[begin];
        if (equals + 2 == end && all_[equals + 1].kind == Kind::NAME) {
            passed_over_.emplace(all_[equals + 1].text);  // another name of it, of a pin perhaps
        }
        const std::size_t question = find_outside(all_, equals + 1, {"?", ",", ";"}),
                          colon = find_outside(all_, question + 1, {"?", ":", ",", ";"});
        const bool choice = is(question, "?") && is(colon, ":") && question < end && colon < end &&
                            find_outside(all_, colon + 1, {"?", ":", ",", ";"}) == end;
        const bool first = choice && is_z(question + 1, colon),
                   second = choice && is_z(colon + 1, end);
        const bool is_one = begin + 1 == equals && first != second;
        if (is_one && buffers_.count(target.text) == 0)
            buffers_[target.text] = {equals, question, colon, end, second};
        else
            for (std::size_t i = begin; i < equals; ++i) passed_over_.emplace(all_[i].text);
    }
    bool is_z(std::size_t begin, std::size_t end) const {
        return begin < end &&
               std::any_of(all_.begin() + static_cast<std::ptrdiff_t>(begin),
                           all_.begin() + static_cast<std::ptrdiff_t>(end), [](const Token& t) {
                               return t.kind == Kind::NUMBER &&
                                      t.text.find_first_of("zZ?") != std::string_view::npos;
                           });
    }

    // What an instance drives, or may, or that is connected with a module that is not known.
    void instance(std::size_t i) {
        const auto other = modules_.find(all_[i].text);
        if (other == modules_.end() && !is(i + 2, "(")) return;
        const ModuleText unknown{};
        const ModuleText& of = other == modules_.end() ? unknown : other->second;
        for (const ConnectionText& c : connections_of(all_, i, of)) {
            const bool reads =
                std::find(of.ports.begin(), of.ports.end(), c.port) != of.ports.end() &&
                !of.outputs.count(c.port) && !of.inouts.count(c.port);
            for (std::size_t at = c.first; at < c.last && !reads; ++at)
                passed_over_.emplace(all_[at].text);
        }
    }

    void make_wire(std::string_view name, const Buffer& b) {
        const std::size_t first = b.second_is_z ? b.question + 1 : b.colon + 1,
                          last = b.second_is_z ? b.colon : b.end;
        for (std::size_t i = b.equals + 1; i < b.end; ++i)
            if (i < first || i >= last) edits_.left_out.insert(i);
        edits_.before[first] += "(";
        edits_.after[last - 1] += ")";
        messages_.push_back({13049,
                             {},
                             all_[b.equals].line,
                             fmt::format("{} is released inside the chip, which has no tri-state "
                                         "buffers: it is a wire, enabled or not",
                                         name)});
    }

    const std::vector<Token>& all_;
    const Modules& modules_;
    Edits& edits_;
    Messages messages_;
    std::map<std::string_view, Buffer> buffers_;      // of the module, by their wires
    std::set<std::string, std::less<>> passed_over_;  // wires that are not theirs alone
};

}  // namespace

Messages join_tri_states(const Tokens& tokens, const Modules& modules, Edits& edits) {
    return TriStates{tokens.all, modules, edits}.run();
}

}  // namespace sim::project
