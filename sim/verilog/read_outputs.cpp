#include "sim/verilog/read_outputs.h"

#include <algorithm>
#include <map>
#include <set>

namespace sim::project {

namespace {

using Kind = Token::Kind;

// One module of a file: its tokens [begin, end), from its name on.
class ModuleTokens {
public:
    ModuleTokens(const std::vector<Token>& all, std::size_t begin, std::size_t end)
        : all_{all}, begin_{begin}, end_{end} {
        for (std::size_t i = begin; i < end; ++i)
            if (all[i].is("output")) declaration(i);
    }

    std::string_view name() const { return all_[begin_].text; }

    // Tokens `output`, by the names of ports that are declared alone.
    const std::map<std::string_view, std::size_t>& outputs() const { return outputs_; }

    // Those that come back into the module.
    std::set<std::string> read_outputs(const Modules& modules) const {
        std::set<std::string_view> released, read;
        std::set<std::string> found;
        for (std::size_t i = find_outside(all_, begin_, {";"}); i < end_; ++i) {
            if (all_[i].is("assign") && i + 2 < end_ && all_[i + 2].is("=")) {
                if (releases(i + 3)) released.insert(all_[i + 1].text);
                ++i;
            } else if (outputs_.count(all_[i].text) && !names_.count(i) && !all_[i - 1].is(".")) {
                read.insert(all_[i].text);
            } else if (const auto other = modules.find(all_[i].text);
                       all_[i].kind == Kind::NAME && other != modules.end()) {
                connected(i, other->second, found);
            }
        }
        for (const std::string_view output : released)
            if (read.count(output)) found.emplace(output);
        return found;
    }

private:
    void declaration(std::size_t output) {
        std::size_t name = output + 1;
        if (name < end_ && all_[name].is("wire")) ++name;
        if (name < end_ && all_[name].is("[")) name = find_outside(all_, name + 1, {"]"}) + 1;
        if (name + 2 >= end_ || all_[name].kind != Kind::NAME) return;
        const Token &next = all_[name + 1], &after = all_[name + 2];
        const bool is_last = next.is(";") || next.is(")");
        if (!is_last &&
            !(next.is(",") && (after.is("input") || after.is("output") || after.is("inout"))))
            return;
        outputs_[all_[name].text] = output;
        names_.insert(name);
    }
    bool releases(std::size_t value) const {
        const std::size_t end = find_outside(all_, value, {";", ","});
        for (; value < end && value < end_; ++value)
            if (all_[value].kind == Kind::NUMBER &&
                all_[value].text.find_first_of("zZ") != std::string_view::npos)
                return true;
        return false;
    }
    void connected(std::size_t instance, const ModuleText& other,
                   std::set<std::string>& found) const {
        if (other.inouts.empty()) return;
        for (const ConnectionText& c : connections_of(all_, instance, other))
            if (c.last == c.first + 1 && other.inouts.count(c.port) &&
                outputs_.count(all_[c.first].text))
                found.emplace(all_[c.first].text);
    }

    const std::vector<Token>& all_;
    const std::size_t begin_, end_;
    std::map<std::string_view, std::size_t> outputs_;
    std::set<std::size_t> names_;  // tokens that declare outputs_
};

std::vector<ModuleTokens> modules_in(const std::vector<Token>& all) {
    std::vector<ModuleTokens> modules;
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        if (!all[i].is("module")) continue;
        const std::size_t begin = i + 1;
        while (i < all.size() && !all[i].is("endmodule")) ++i;
        modules.emplace_back(all, begin, i);
    }
    return modules;
}

}  // namespace

void find_read_outputs(const std::vector<Tokens>& files, Modules& modules) {
    for (bool is_new = true; is_new;) {
        is_new = false;
        for (const Tokens& file : files)
            for (const ModuleTokens& module : modules_in(file.all)) {
                const auto known = modules.find(module.name());
                if (known == modules.end() || module.outputs().empty()) continue;
                for (const std::string& output : module.read_outputs(modules)) {
                    known->second.outputs.erase(output);
                    is_new |= known->second.inouts.insert(output).second;
                }
            }
    }
}

void make_inouts(const std::vector<Token>& tokens, const Modules& modules, Edits& edits) {
    for (const ModuleTokens& module : modules_in(tokens)) {
        const auto known = modules.find(module.name());
        if (known == modules.end()) continue;
        for (const auto& [name, output] : module.outputs())
            if (known->second.inouts.count(std::string{name})) {
                edits.left_out.insert(output);
                edits.before[output] += " inout ";
            }
    }
}

}  // namespace sim::project
