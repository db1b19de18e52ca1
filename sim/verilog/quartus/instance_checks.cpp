#include "sim/verilog/quartus/instance_checks.h"

#include <set>
#include <string_view>

#include <fmt/format.h>

namespace sim::project {

namespace {

using Kind = Token::Kind;

class InstanceChecks {
public:
    InstanceChecks(const std::vector<Token>& all, const Modules& modules, const std::string& name,
                   TextChecks& found)
        : all_{all}, modules_{modules}, name_{name}, found_{found} {}

    void run() {
        for (std::size_t i = 0; i + 1 < all_.size(); ++i) {
            if (!all_[i].is("module")) continue;
            std::size_t end = i;
            while (end < all_.size() && !all_[end].is("endmodule")) ++end;
            module_ = all_[i + 1].text;
            module(i + 2, end);
            i = end;
        }
    }

private:
    bool is(std::size_t i, std::string_view text) const {
        return i < all_.size() && all_[i].is(text);
    }
    bool is_name(std::size_t i) const {
        return i < all_.size() && all_[i].kind == Kind::NAME && !is_keyword(all_[i].text);
    }

    void module(std::size_t begin, std::size_t end) {
        registers_.clear();
        instances_.clear();
        for (std::size_t i = begin; i < end; ++i)
            if (is(i, "reg")) declarations(i + 1);
        unsigned conditions = 0;
        for (std::size_t i = begin; i < end; ++i) {
            follow_conditions(all_[i].gap, conditions);
            if (conditions) continue;
            if (is(i, "defparam"))
                i = find_outside(all_, i, {";"});
            else if (const auto of = modules_.find(all_[i].text);
                     of != modules_.end() && is_name(i))
                instance(i, of->second);
            else if (instances_.count(all_[i].text) && is(i + 1, ".") && is_name(i + 2) &&
                     all_[i + 1].gap.empty() && !is(i - 1, "."))
                add(10207, i,
                    fmt::format("{}.{} is inside the instance {}; make it an output of that module",
                                all_[i].text, all_[i + 2].text, all_[i].text));
        }
    }
    void declarations(std::size_t i) {
        if (is(i, "signed")) ++i;
        while (is(i, "[")) i = find_outside(all_, i + 1, {"]"}) + 1;
        for (; is_name(i) && !is(i + 1, "["); i += 2) {
            registers_.insert(all_[i].text);
            if (!is(i + 1, ",")) return;
        }
    }

    void instance(std::size_t i, const ModuleText& of) {
        std::size_t named = i + 1;
        if (is(named, "#")) named = closing(named + 1) + 1;
        if (is_name(named)) instances_.insert(all_[named].text);
        if (of.in_library) return;
        for (const ConnectionText& c : connections_of(all_, i, of)) {
            if (!of.outputs.count(c.port) && !of.inouts.count(c.port)) continue;
            int depth = 0;
            for (std::size_t at = c.first; at < c.last; ++at) {
                depth += is(at, "[") - is(at, "]");
                if (depth == 0 && registers_.count(all_[at].text))
                    add(10663, at,
                        fmt::format("{} is a reg, and is connected with the output {} of an "
                                    "instance; declare it as wire",
                                    all_[at].text, c.port));
            }
        }
    }
    std::size_t closing(std::size_t open) const { return find_outside(all_, open + 1, {")"}); }

    void add(unsigned number, std::size_t i, std::string text) {
        found_.of_modules.push_back(
            {module_, true, {number, name_, all_[i].line, std::move(text)}});
    }

    const std::vector<Token>& all_;
    const Modules& modules_;
    const std::string& name_;
    TextChecks& found_;
    std::string module_;
    std::set<std::string_view> registers_, instances_;
};

}  // namespace

void check_instances(const std::vector<Token>& tokens, const Modules& modules,
                     const std::string& name, TextChecks& found) {
    InstanceChecks{tokens, modules, name, found}.run();
}

}  // namespace sim::project
