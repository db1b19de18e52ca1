#include "sim/project/released_registers.h"

#include <utility>

#include <fmt/format.h>

namespace sim::project {

namespace {

using Kind = Token::Kind;
using NameSet = std::set<std::string, std::less<>>;

// Calls take(begin, end) for each module, from its name up to `endmodule`.
template <class Take>
void each_module(const std::vector<Token>& all, Take take) {
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        if (!all[i].is("module")) continue;
        const std::size_t begin = ++i;
        while (i < all.size() && !all[i].is("endmodule")) ++i;
        take(begin, i);
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

}  // namespace

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
        NameSet at_pins, told;
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
            if (told.emplace(all[target].text).second)
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
