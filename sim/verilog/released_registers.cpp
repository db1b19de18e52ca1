#include "sim/verilog/released_registers.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "sim/verilog/items.h"

namespace sim::project {

namespace {

using Kind = Token::Kind;
using NameSet = std::set<std::string, std::less<>>;

// Calls visit(begin, end) for each module, from its name up to `endmodule`.
template <class Visit>
void each_module(const std::vector<Token>& all, Visit visit) {
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        if (!all[i].is("module")) continue;
        const std::size_t begin = ++i;
        while (i < all.size() && !all[i].is("endmodule")) ++i;
        visit(begin, i);
    }
}

// Whether the token is a name, or the name of a part, by itself or in a concatenation.
bool is_passed_on(const std::vector<Token>& all, std::size_t i) {
    const Token& before = all[i - 1];
    if (all[i].kind != Kind::NAME || !(before.is("=") || before.is(",") || before.is("{")))
        return false;
    std::size_t next = i + 1;
    if (next < all.size() && all[next].is("[")) next = find_outside(all, next + 1, {"]"}) + 1;
    return next < all.size() && (all[next].is(";") || all[next].is(",") || all[next].is("}"));
}

// The ports, and what the module's assigns bring to them.
NameSet names_at_pins(const std::vector<Token>& all, std::size_t begin, std::size_t end,
                      const std::set<std::string>& ports) {
    NameSet names{ports.begin(), ports.end()};
    for (bool is_new = !names.empty(); is_new;) {
        is_new = false;
        for (std::size_t i = begin; i < end; ++i) {
            if (!all[i].is("assign") && !all[i].is("wire") && !all[i].is("tri")) continue;
            const std::size_t equals = find_outside(all, i, {"=", ";"}),
                              last = find_outside(all, equals, {";"});
            bool reaches = false;
            for (std::size_t at = i + 1; at < equals && !reaches; ++at)
                reaches = names.count(all[at].text) > 0;
            for (std::size_t at = equals; at < last && reaches; ++at)
                if (is_passed_on(all, at)) is_new |= names.emplace(all[at].text).second;
            i = last;
        }
    }
    return names;
}

bool is_released(const Token& token) {
    return token.kind == Kind::NUMBER && token.text.find('\'') != std::string_view::npos &&
           token.text.find_first_of("zZ") != std::string_view::npos;
}

// The register that a statement of a block sets to an expression with the token `i`; the end if
// that is something else.
std::size_t target_of(const std::vector<Token>& all, std::size_t begin, std::size_t i) {
    int depth = 0;
    for (; i > begin; --i) {
        const Token& token = all[i - 1];
        if (token.is(";") || token.is("begin") || token.is("assign")) return all.size();
        depth += token.is(")") - token.is("(");
        if (depth < 0) {
            const Token& before = all[i - 2];
            if (before.is("if") || before.is("case") || before.is("while") || before.is("for"))
                return all.size();
            depth = 0;
        }
        if (depth == 0 && token.is("=")) break;
    }
    if (i > begin + 1 && all[i - 2].is("<")) --i;  // <=
    if (i <= begin + 1) return all.size();
    std::size_t name = i - 2;
    if (all[name].is("]")) {
        while (name > begin && !all[name].is("[")) --name;
        if (name == begin) return all.size();
        --name;
    }
    const Token& before = all[name - 1];
    const bool in_block = before.is(";") || before.is("begin") || before.is("end") ||
                          before.is("else") || before.is(")") || before.is(":") ||
                          before.is("endcase");
    return all[name].kind == Kind::NAME && in_block ? name : all.size();
}

// A module's registers at pins that its blocks release, each as a value and an enable.
class EnabledRegisters {
public:
    EnabledRegisters(const std::vector<Token>& all, std::size_t begin, std::size_t end,
                     const NameSet& names, Edits& edits)
        : all_{all}, begin_{begin}, end_{end}, edits_{edits} {
        find_assignments(names);
        if (assignments_.empty()) return;
        const std::size_t header = find_outside(all, begin, {";"});
        for (std::size_t i = begin; i < end; ++i)
            if (all[i].is("reg") || all[i].is("logic")) i = declaration(i, header);
        for (const Assignment& assignment : assignments_)
            if (enabled_.count(all[assignment.target].text)) assign(assignment);
    }

private:
    struct Assignment {
        std::size_t target, sign, value, end;  // the sign's first token; its semicolon
    };

    std::string text(std::size_t begin, std::size_t end) const {
        return begin < end ? ' ' + text_between(all_, begin, end) : "";
    }

    bool is(std::size_t i, std::string_view word) const {
        return i < all_.size() && all_[i].is(word);
    }

    // All of the registers `names`.
    void find_assignments(const NameSet& names) {
        for (std::size_t i = begin_; i < end_; ++i) {
            if (!all_[i].is("=") || target_of(all_, begin_, i + 1) == all_.size()) continue;
            const std::size_t target = target_of(all_, begin_, i + 1),
                              end = find_outside(all_, i, {";"});
            if (!names.count(all_[target].text) || end >= end_) continue;
            std::size_t value = i + 1;  // after a delay
            if (all_[value].is("#"))
                value = all_[value + 1].is("(") ? closing(all_, value + 1) + 1 : value + 2;
            if (value >= end) continue;
            assignments_.push_back({target, i - all_[i - 1].is("<"), value, end});
            if (target + 1 != assignments_.back().sign || !is_whole(value, end))
                in_parts_.emplace(all_[target].text);
        }
    }
    // All bits are released together.
    bool is_whole(std::size_t begin, std::size_t end) const {
        const auto [question, colon] = choice(begin, end);
        if (colon < end) return is_whole(question + 1, colon) && is_whole(colon + 1, end);
        if (is_in_parentheses(begin, end)) return is_whole(begin + 1, end - 1);
        return !releases(begin, end) || (begin + 1 == end && !enables_any(begin));
    }
    bool releases(std::size_t begin, std::size_t end) const {
        return std::any_of(all_.begin() + static_cast<std::ptrdiff_t>(begin),
                           all_.begin() + static_cast<std::ptrdiff_t>(end), is_released);
    }
    bool is_in_parentheses(std::size_t begin, std::size_t end) const {
        return all_[begin].is("(") && closing(all_, begin) + 1 == end;
    }
    // The question mark and the colon of a ? b : c; the end twice: it is something else.
    std::pair<std::size_t, std::size_t> choice(std::size_t begin, std::size_t end) const {
        const std::size_t question = find_outside(all_, begin, {"?", ";"});
        std::size_t colon = question;
        for (int open = 1; colon < end && open > 0;) {
            colon = find_outside(all_, colon + 1, {"?", ":", ";"});
            if (colon < end) open += all_[colon].is("?") ? 1 : -1;
        }
        return colon < end ? std::pair{question, colon} : std::pair{end, end};
    }
    // A number with 1 in place of its digits, 0 where they are released.
    std::string bits(std::size_t number) const {
        std::string text{all_[number].text};
        const std::size_t base = text.find_first_of("bBoOhHdD", text.find('\''));
        const int radix = std::tolower(text[base]);
        const char all = radix == 'h' ? 'f' : radix == 'o' ? '7' : '1';
        for (std::size_t i = base + 1; i < text.size(); ++i)
            if (text[i] != '_' && text[i] != ' ') text[i] = is_z(text[i]) ? '0' : all;
        return text;
    }
    bool enables_any(std::size_t number) const {
        const std::string text = bits(number);
        return text.find_first_not_of("0_ ", text.find_first_of("bBoOhHdD", text.find('\'')) + 1) !=
               std::string::npos;
    }
    static bool is_z(char c) { return c == 'z' || c == 'Z' || c == '?'; }
    static std::string ones(const std::string& value) {
        return fmt::format("({0}) | ~({0})", value);
    }
    // The enable of the expression [begin, end), of one bit or of as many as it has.
    std::string enable(std::size_t begin, std::size_t end, bool in_parts) const {
        const auto [question, colon] = choice(begin, end);
        if (colon < end)
            return fmt::format("{} ? {} : {}", text(begin, question),
                               enable(question + 1, colon, in_parts),
                               enable(colon + 1, end, in_parts));
        if (is_in_parentheses(begin, end))
            return fmt::format("({})", enable(begin + 1, end - 1, in_parts));
        if (!in_parts) return releases(begin, end) ? "1'b0" : "1'b1";
        return item(begin, end);
    }
    // Of as many bits as it has.
    std::string item(std::size_t begin, std::size_t end) const {
        if (!releases(begin, end)) return ones(text(begin, end));
        if (begin + 1 == end) return bits(begin);
        const std::size_t brace = find_outside(all_, begin, {"{"});  // {8{1'bz}}
        return fmt::format("{}{{{}}}", text(begin, brace), items(brace + 1, end - 1));
    }
    // Of what stands in braces.
    std::string items(std::size_t begin, std::size_t end) const {
        std::string all;
        while (begin < end) {
            const std::size_t next = std::min(find_outside(all_, begin, {",", "}"}), end);
            all += (all.empty() ? "" : ", ") + item(begin, next);
            begin = next + 1;
        }
        return all;
    }

    // reg [7:0] a, b = 1; or output reg [7:0] a, and so on: without those that get an enable, which
    // are declared after it, or after the module's header.  Its last token.
    std::size_t declaration(std::size_t reg, std::size_t header) {
        std::size_t name = reg + 1;
        if (is(name, "signed")) ++name;
        while (is(name, "[")) name = find_outside(all_, name + 1, {"]"}) + 1;
        if (name >= end_) return reg;
        const bool is_port = all_[reg - 1].is("output");
        const std::string type = text(reg + 1, name);
        std::string kept, added;
        bool is_first = true;
        for (std::size_t end = name; name < end_; name = end + 1) {
            end = std::min(find_outside(all_, name, {",", ";", ")"}), end_);
            const std::size_t last = end;
            if (all_[name].kind != Kind::NAME || is_keyword(all_[name].text)) break;
            const std::string_view word = all_[name].text;
            const bool is_memory = is(name + 1, "[");
            if (!is_memory && releases_in_block(word)) {
                enabled_.insert(std::string{word});
                if (is_port) kept += fmt::format("{}output{} {}", is_first ? "" : ", ", type, word);
                added += declarations(name, last, type, is_port);
            } else {
                kept += is_port ? fmt::format("{}output {}{} {}", is_first ? "" : ", ",
                                              all_[reg].text, type, text(name, last))
                                : fmt::format("{}{}{};", all_[reg].text, type, text(name, last));
            }
            is_first = false;
            if (!is(end, ",")) {
                name = end;
                break;
            }
        }
        if (added.empty() || name >= end_) return reg;
        // `name` is after the last; a comma before the next direction stays.
        std::size_t last = name;
        if (!all_[last].is(";") && !all_[last].is(")")) --last;
        const std::size_t first = is_port ? reg - 1 : reg;
        const bool takes_semicolon = !is_port && all_[last].is(";");
        for (std::size_t i = first; i < last + takes_semicolon; ++i) edits_.left_out.insert(i);
        edits_.before[first] += kept;
        if (is_port && last < header)
            edits_.after[header] += added;
        else
            edits_.after[last] += added;
        return last;
    }
    // Of the name at token `at`, with its first value up to `end`.
    std::string declarations(std::size_t at, std::size_t end, const std::string& type,
                             bool is_port) const {
        const std::string_view name = all_[at].text;
        const bool in_parts = in_parts_.count(name) > 0;
        std::string all = is_port ? "" : fmt::format(" wire{} {};", type, name);
        all += fmt::format(" reg{} {}__value; reg{} {}__enable;", type, name, in_parts ? type : "",
                           name);
        if (in_parts)
            all += fmt::format(
                " genvar {0}__i; generate for ({0}__i = $low({0}__value); {0}__i <= "
                "$high({0}__value); {0}__i = {0}__i + 1) begin : {0}__bits assign "
                "{0}[{0}__i] = {0}__enable[{0}__i] ? {0}__value[{0}__i] : 1'bz; end "
                "endgenerate",
                name);
        else
            all += fmt::format(
                " assign {0} = {0}__enable ? {0}__value : "
                "{{$bits({0}__value){{1'bz}}}};",
                name);
        if (at + 2 >= end) return all;
        const bool released = releases(at + 2, end);
        const std::string value = text(at + 2, end);
        return all + fmt::format(" initial begin {0}__value = {1}; {0}__enable = {2}; end", name,
                                 released ? "1'b0" : value,
                                 released   ? "1'b0"
                                 : in_parts ? ones(value)
                                            : "1'b1");
    }
    bool releases_in_block(std::string_view name) const {
        return std::any_of(assignments_.begin(), assignments_.end(), [&](const Assignment& a) {
            return all_[a.target].is(name) && releases(a.value, a.end);
        });
    }

    void assign(const Assignment& a) {
        const std::string name{all_[a.target].text};
        edits_.left_out.insert(a.target);
        edits_.before[a.target] += fmt::format("begin {}__value", name);
        for (std::size_t i = a.value; i < a.end; ++i)
            if (is_released(all_[i])) {
                std::string value{all_[i].text};
                for (char& c : value)
                    if (is_z(c)) c = '0';
                edits_.left_out.insert(i);
                edits_.before[i] += value;
            }
        edits_.after[a.end] +=
            fmt::format(" {}__enable{} {}; end", name, text(a.target + 1, a.value),
                        enable(a.value, a.end, in_parts_.count(name) > 0));
    }

    const std::vector<Token>& all_;
    const std::size_t begin_, end_;
    Edits& edits_;
    std::vector<Assignment> assignments_;
    NameSet in_parts_, enabled_;
};

}  // namespace

std::string with_enables(std::string_view text, const PinPorts& pins) {
    const Tokens tokens = tokens_of(text);
    if (pins.empty() || std::none_of(tokens.all.begin(), tokens.all.end(), is_released))
        return std::string{text};
    Edits edits;
    each_module(tokens.all, [&](std::size_t begin, std::size_t end) {
        const auto ports = pins.find(tokens.all[begin].text);
        if (ports == pins.end()) return;
        EnabledRegisters{tokens.all, begin, end,
                         names_at_pins(tokens.all, begin, end, ports->second), edits};
    });
    return changed_text(tokens, edits);
}

PinPorts pin_ports(const std::vector<Tokens>& files, const Modules& modules,
                   const std::string& top) {
    PinPorts pins;
    const auto module = modules.find(top);
    if (module == modules.end()) return pins;
    pins[top] = module->second.outputs;
    pins[top].insert(module->second.inouts.begin(), module->second.inouts.end());
    for (bool is_new = true; is_new;) {
        is_new = false;
        for (const Tokens& file : files)
            each_module(file.all, [&](std::size_t begin, std::size_t end) {
                const auto ports = pins.find(file.all[begin].text);
                if (ports == pins.end()) return;
                const NameSet names = names_at_pins(file.all, begin, end, ports->second);
                for (std::size_t i = find_outside(file.all, begin, {";"}); i < end; ++i) {
                    const auto other = modules.find(file.all[i].text);
                    if (file.all[i].kind != Kind::NAME || other == modules.end()) continue;
                    for (const ConnectionText& c : connections_of(file.all, i, other->second))
                        for (std::size_t at = c.first; at < c.last; ++at)
                            if (names.count(file.all[at].text) && !c.port.empty())
                                is_new |= pins[other->first].insert(c.port).second;
                }
            });
    }
    return pins;
}

Messages keep_released_registers(const std::vector<Token>& all, const PinPorts& pins,
                                 Edits& edits) {
    Messages messages;
    if (pins.empty()) return messages;
    each_module(all, [&](std::size_t begin, std::size_t end) {
        NameSet at_pins, noted;
        bool is_known = false;
        for (std::size_t i = begin; i < end; ++i) {
            if (!is_released(all[i])) continue;
            const std::size_t target = target_of(all, begin, i);
            if (target == all.size()) continue;
            if (!std::exchange(is_known, true))
                if (const auto ports = pins.find(all[begin].text); ports != pins.end())
                    at_pins = names_at_pins(all, begin, end, ports->second);
            if (at_pins.count(all[target].text)) continue;
            std::string value{all[i].text};
            for (char& c : value)
                if (c == 'z' || c == 'Z') c = 'x';
            edits.left_out.insert(i);
            edits.before[i] += value;
            if (noted.emplace(all[target].text).second)
                messages.push_back({13049,
                                    {},
                                    all[i].line,
                                    fmt::format("{} is released inside the chip, which has no "
                                                "tri-state buffers: it is then what the logic "
                                                "makes of it",
                                                all[target].text)});
        }
    });
    return messages;
}

}  // namespace sim::project
