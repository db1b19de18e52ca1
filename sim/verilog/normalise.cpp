#include "sim/verilog/normalise.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <sstream>

#include <fmt/format.h>

#include "sim/verilog/assertions.h"
#include "sim/verilog/block_variables.h"
#include "sim/verilog/items.h"
#include "sim/verilog/parameter_types.h"
#include "sim/verilog/power_up.h"
#include "sim/verilog/project_error.h"
#include "sim/verilog/pulled_inputs.h"
#include "sim/verilog/quartus/instance_checks.h"
#include "sim/verilog/quartus/syntax.h"
#include "sim/verilog/read_outputs.h"
#include "sim/verilog/registers.h"
#include "sim/verilog/reorder.h"
#include "sim/verilog/sensitivity.h"
#include "sim/verilog/tokens.h"
#include "sim/verilog/tri_states.h"

namespace sim::project {

namespace {

using Kind = Token::Kind;

// Words that SystemVerilog has taken; and those that show that a .v file is SystemVerilog.
bool is_new_keyword(std::string_view word) {
    static constexpr std::string_view WORDS[] = {
        "assert",   "before",    "bind",       "bit",           "break",
        "byte",     "chandle",   "checker",    "class",         "clocking",
        "const",    "context",   "continue",   "cover",         "cross",
        "dist",     "do",        "expect",     "export",        "extends",
        "extern",   "final",     "global",     "iff",           "ignore_bins",
        "implies",  "import",    "inside",     "int",           "let",
        "local",    "longint",   "matches",    "modport",       "new",
        "next",     "null",      "packed",     "priority",      "program",
        "property", "protected", "pure",       "rand",          "ref",
        "restrict", "return",    "sequence",   "shortint",      "solve",
        "static",   "string",    "strong",     "struct",        "super",
        "tagged",   "this",      "throughout", "timeprecision", "timeunit",
        "type",     "typedef",   "union",      "unique",        "until",
        "var",      "virtual",   "void",       "weak",          "within"};
    return std::find(std::begin(WORDS), std::end(WORDS), word) != std::end(WORDS);
}
bool shows_system_verilog(std::string_view word) {
    static constexpr std::string_view WORDS[] = {"always_comb", "always_ff", "always_latch",
                                                 "enum",        "interface", "logic",
                                                 "package",     "typedef"};
    return std::find(std::begin(WORDS), std::end(WORDS), word) != std::end(WORDS);
}

// Keywords of trireg, which no FPGA has: Quartus takes them as names.
bool is_charge_strength(std::string_view word) {
    return word == "small" || word == "medium" || word == "large";
}

class Normaliser {
public:
    Normaliser(std::string_view text, const std::string& name, const OpenInputs& open_inputs,
               const Modules& modules, const std::vector<InoutFit>& inout_fits,
               const PinPorts& pins)
        : tokens_{tokens_of(text)}, items_{tokens_.all}, name_{name}, modules_{modules} {
        reorder(tokens_.all, items_, edits_);
        repeat_parameter_types(tokens_.all, edits_);
        tri_states_ = join_tri_states(tokens_, modules, edits_);
        for (Message& m : keep_released_registers(tokens_.all, pins, edits_))
            tri_states_.push_back(std::move(m));
        enable_part_drivers(tokens_, modules, edits_);
        make_inouts(tokens_.all, modules, edits_);
        make_pulled_inputs_wires(tokens_.all, edits_);
        begin_block_variables(tokens_.all, edits_);
        make_registers(tokens_, edits_);
        complete_lists(tokens_, edits_);
        fit_inouts(tokens_.all, modules, inout_fits, edits_);
        resets_ = reset_statements(tokens_.all);
        init_names_ = read_at_run_time(tokens_, edits_);
        for (std::size_t i = 0; i < tokens_.all.size(); ++i) {
            if (tokens_.all[i].kind != Kind::NAME || is_instance_name(tokens_.all, i) ||
                (i > 0 && tokens_.all[i - 1].is("module")))
                continue;
            if (open_inputs.count(tokens_.all[i].text)) connect(i, open_inputs);
            if (const auto of = modules.find(tokens_.all[i].text); of != modules.end()) {
                open_constants(i, of->second);
                leave_out_absent(i, of->second);
            }
        }
    }

    Normalised run(bool system_verilog) {
        Normalised result;
        checks_ = check_text(tokens_.all, items_, name_, system_verilog);
        find_syntax_errors(tokens_.all, items_, name_, system_verilog, checks_);
        if (!system_verilog) check_instances(tokens_.all, modules_, name_, checks_);
        for (const Message& m : tri_states_)
            checks_.warnings.push_back({m.number, name_, m.line, m.text});
        std::size_t next_reset = 0;
        if (!system_verilog) choose_keywords(result.text);
        for (std::size_t i = 0; i < tokens_.all.size(); ++i) {
            const Token& token = tokens_.all[i];
            result.text += without_pragmas(token.gap);
            if (const auto here = edits_.notes.find(i); here != edits_.notes.end())
                changed(token, here->second);
            if (const auto here = edits_.before.find(i); here != edits_.before.end())
                result.text += in_one_line(here->second);
            if (edits_.left_out.count(i)) {
                result.text.append(lines_in(token.text), '\n');
                continue;
            }
            if (token.is(",") && next(i) && next(i)->is(")")) {
                changed(token, "dropped the comma before \")\"");
            } else {
                result.text += text_of_token(token);
            }
            if (items_.unnamed_instance(i)) {
                warn(10846, token, fmt::format("the instance of {} has no name", token.text));
                changed(token, fmt::format("named the instance of {}", token.text));
                add_name(i);
            }
            if (const auto here = edits_.after.find(i); here != edits_.after.end())
                result.text += in_one_line(here->second);
            for (; next_reset < resets_.size() && resets_[next_reset].after == i; ++next_reset)
                result.text += at_power_up(resets_[next_reset]);
        }
        result.text += without_pragmas(tokens_.tail);
        if (begun_) result.text += "\n`end_keywords\n";
        result.changes = std::move(changes_);
        result.init_names = std::move(init_names_);
        result.checks = std::move(checks_);
        return result;
    }

private:
    const Token* next(std::size_t i, std::size_t ahead = 1) const {
        return i + ahead < tokens_.all.size() ? &tokens_.all[i + ahead] : nullptr;
    }
    void changed(const Token& token, const std::string& what) {
        changes_.push_back(fmt::format("{}:{}: {}", name_, token.line, in_one_line(what)));
    }

    void warn(unsigned number, const Token& token, const std::string& what) {
        checks_.warnings.push_back({number, name_, token.line, in_one_line(what)});
    }

    std::string at_power_up(const ResetStatement& reset) {
        std::string text = " initial";
        const std::size_t noted = changes_.size(), warned = checks_.warnings.size();
        for (std::size_t i = reset.begin; i < reset.end; ++i)
            text += (i > reset.begin && tokens_.all[i].gap.empty() ? "" : " ") +
                    text_of_token(tokens_.all[i]);
        changes_.resize(noted);  // of the original
        checks_.warnings.erase(checks_.warnings.begin() + static_cast<std::ptrdiff_t>(warned),
                               checks_.warnings.end());
        return text;
    }

    // What is written or noted of a text in quotes, which may go over lines, as in a broken file.
    static std::string in_one_line(std::string text) {
        std::replace(text.begin(), text.end(), '\n', ' ');
        return text;
    }
    static std::size_t lines_in(std::string_view text) {
        return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    }

    // A comment that begins with the tool's name is an order to Verilator; an older one does not
    // know those for a newer one, and Quartus none.
    static std::string without_pragmas(std::string_view gap) {
        std::string text{gap};
        for (const char* open : {"//", "/*"})
            for (std::size_t at = text.find(open); at != std::string::npos;
                 at = text.find(open, at + 2)) {
                const std::size_t word = text.find_first_not_of(" \t", at + 2);
                if (word == std::string::npos) break;
                std::string name = text.substr(word, 9);
                std::transform(name.begin(), name.end(), name.begin(), ::tolower);
                if (name.compare(0, 9, "verilator") == 0) text.insert(at + 2, " -");
            }
        return text;
    }

    void choose_keywords(std::string& text) {
        const Token* first = nullptr;
        for (const Token& token : tokens_.all) {
            if (token.kind != Kind::NAME) continue;
            if (shows_system_verilog(token.text)) return;
            if (!first && is_new_keyword(token.text)) first = &token;
        }
        if (!first) return;
        warn(10463, *first, fmt::format("\"{}\" is a word of SystemVerilog", first->text));
        changed(*first, fmt::format("\"{}\" is read as a name, as in Verilog-2005", first->text));
        text += "`begin_keywords \"1364-2005\" ";
        begun_ = true;
    }

    void add_name(std::size_t i) {
        std::size_t at = i;
        if (tokens_.all[i + 1].is("#")) at = closing(tokens_.all, i + 2);
        edits_.after[at] += fmt::format(" de1sim_unnamed_{} ", ++unnamed_);
    }
    // Adds the connections that the instance of a model at `i` leaves open.
    // Quartus takes an output that is connected with a number for one that is open.
    void open_constants(std::size_t i, const ModuleText& module) {
        for (const ConnectionText& c : connections_of(tokens_.all, i, module)) {
            const Token& value = tokens_.all[c.first];
            if (!module.outputs.count(c.port)) continue;
            if (value.is("{")) open_bits(i, c);
            if (c.last != c.first + 1 || value.kind != Kind::NUMBER) continue;
            edits_.left_out.insert(c.first);
            edits_.notes[c.first] =
                fmt::format("left output {} open, which is connected with {}", c.port, value.text);
        }
    }
    // .q({1'b0, HEX0}): the bits of constants, which have a size, are open.
    void open_bits(std::size_t instance, const ConnectionText& c) {
        const auto& all = tokens_.all;
        for (std::size_t at = c.first + 1; at + 1 < c.last; ++at) {
            if (all[at].kind != Kind::NUMBER || !(all[at - 1].is("{") || all[at - 1].is(",")) ||
                !(all[at + 1].is("}") || all[at + 1].is(",")))
                continue;
            const std::string size{all[at].text.substr(0, all[at].text.find('\''))};
            if (size.size() == all[at].text.size() || size.empty()) continue;
            const std::string open = fmt::format("de1sim_unused_{}", at);
            edits_.before[instance] += fmt::format("wire [{}-1:0] {}; ", size, open);
            edits_.before[at] += open;
            edits_.left_out.insert(at);
            edits_.notes[at] = fmt::format(
                "left bits of output {} open, which are connected with {}", c.port, all[at].text);
        }
    }
    // `.port()`, of a port that the module has not: published projects that run on boards have it.
    void leave_out_absent(std::size_t i, const ModuleText& module) {
        const auto& all = tokens_.all;
        const std::size_t end = find_outside(all, i, {";"});
        if (end >= all.size() || module.ports.empty()) return;
        for (std::size_t at = i + 1; at + 4 < end; ++at) {
            if (!all[at].is(".") || !all[at + 2].is("(") || !all[at + 3].is(")")) continue;
            const std::string port{all[at + 1].text};
            if (std::find(module.ports.begin(), module.ports.end(), port) != module.ports.end())
                continue;
            for (std::size_t n = at; n < at + 4; ++n) edits_.left_out.insert(n);
            std::size_t comma = at + 4;
            if (!all[comma].is(","))
                for (comma = at - 1; edits_.left_out.count(comma);) --comma;
            if (all[comma].is(",")) edits_.left_out.insert(comma);
            edits_.notes[at] = fmt::format(
                "left out port {}, which is not connected, and which {} "
                "has not",
                port, all[i].text);
        }
    }
    void connect(std::size_t i, const OpenInputs& open_inputs) {
        std::size_t open = i + 1;
        if (next(i) && next(i)->is("#")) open = closing(tokens_.all, open + 1) + 1;
        if (open < tokens_.all.size() && tokens_.all[open].kind == Kind::NAME) ++open;
        if (open + 1 >= tokens_.all.size() || !tokens_.all[open].is("(") ||
            !tokens_.all[open + 1].is("."))
            return;
        const std::size_t close = closing(tokens_.all, open);
        std::map<std::string, std::size_t, std::less<>> connected;  // to its parenthesis
        for (std::size_t at = open + 1; at + 2 < close; ++at)
            if (tokens_.all[at].is(".") && tokens_.all[at + 2].is("(")) {
                connected.emplace(tokens_.all[at + 1].text, at + 2);
                at = closing(tokens_.all, at + 2);
            }
        std::string added;
        const auto [begin, end] = open_inputs.equal_range(tokens_.all[i].text);
        for (auto input = begin; input != end; ++input) {
            const auto there = connected.find(input->second);
            if (there == connected.end())
                added += fmt::format(".{}(-1), ", input->second);
            else if (tokens_.all[there->second + 1].is(")"))
                edits_.after[there->second] += "-1";
        }
        edits_.after[open] += added;
    }
    std::string text_of_token(const Token& token) {
        if (token.kind == Kind::NUMBER) return literal(token);
        return is_charge_strength(token.text) ? fmt::format("\\{} ", token.text)
                                              : std::string{token.text};
    }
    std::string literal(const Token& token) {
        const std::string_view text = token.text;
        const std::size_t quote = text.find('\'');
        if (quote == 0 || quote == std::string_view::npos) return std::string{text};
        std::size_t base = quote + 1;
        if (text[base] == 's' || text[base] == 'S') ++base;
        unsigned bits_per_digit = 0;
        switch (std::tolower(static_cast<unsigned char>(text[base]))) {
            case 'b': bits_per_digit = 1; break;
            case 'o': bits_per_digit = 3; break;
            case 'h': bits_per_digit = 4; break;
            default: return decimal(token, quote, base);
        }
        const unsigned long size = size_of(text.substr(0, quote));
        std::string digits;
        for (const char c : text.substr(base + 1))
            if (c != '_' && c != ' ' && c != '\t') digits += c;
        const unsigned long most = (size + bits_per_digit - 1) / bits_per_digit;
        if (size == 0) return std::string{text};
        std::string kept = digits.size() > most ? digits.substr(digits.size() - most) : digits;
        const unsigned over = static_cast<unsigned>(most * bits_per_digit - size);
        const bool cut_digit = kept.size() == most && over > 0 && value_of(kept[0]) >= 0 &&
                               value_of(kept[0]) >> (bits_per_digit - over) != 0;
        if (cut_digit)
            kept[0] = "0123456789abcdef"[value_of(kept[0]) & ((1 << (bits_per_digit - over)) - 1)];
        if (digits.size() <= most && !cut_digit) return std::string{text};
        const std::string now = std::string{text.substr(0, base + 1)} + kept;
        if (cut_digit || digits.find_first_not_of('0') < digits.size() - most) {
            warn(10229, token,
                 fmt::format("{} has more than {} bits, taken as {}", text, size, now));
            changed(token, fmt::format("{} has too many digits, taken as {}", text, now));
        } else
            changed(token, fmt::format("{} has too many digits, shortened to {}", text, now));
        return now;
    }
    std::string decimal(const Token& token, std::size_t quote, std::size_t base) {
        const unsigned long size = size_of(token.text.substr(0, quote));
        std::string digits;
        for (const char c : token.text.substr(base + 1))
            if (std::isdigit(static_cast<unsigned char>(c))) digits += c;
        if (size == 0 || size >= 64 || digits.empty() || digits.size() > 18)
            return std::string{token.text};
        const unsigned long long value = std::stoull(digits), mask = (1ull << size) - 1;
        if (value <= mask) return std::string{token.text};
        const std::string now = fmt::format("{}{}", token.text.substr(0, base + 1), value & mask);
        warn(10259, token, fmt::format("{} does not fit in {} bits", token.text, size));
        changed(token,
                fmt::format("{} does not fit in {} bits, taken as {}", token.text, size, now));
        return now;
    }
    static int value_of(char c) {
        if (c >= '0' && c <= '9') return c - '0';
        const int letter = std::tolower(static_cast<unsigned char>(c));
        return letter >= 'a' && letter <= 'f' ? letter - 'a' + 10 : -1;
    }
    static unsigned long size_of(std::string_view text) {
        std::string digits;
        for (const char c : text)
            if (std::isdigit(static_cast<unsigned char>(c))) digits += c;
        return digits.empty() || digits.size() > 6 ? 0 : std::stoul(digits);
    }

    Tokens tokens_;
    const Items items_;
    const std::string& name_;
    const Modules& modules_;
    Edits edits_;
    std::vector<ResetStatement> resets_;
    Messages tri_states_;
    std::vector<std::string> changes_;
    std::vector<InitName> init_names_;
    TextChecks checks_;
    unsigned unnamed_ = 0;
    bool begun_ = false;
};

}  // namespace

OpenInputs read_open_inputs(const std::filesystem::path& table) {
    OpenInputs inputs;
    std::istringstream lines{text_of(table)};
    std::string line;
    std::getline(lines, line);  // the titles
    while (std::getline(lines, line)) {
        const std::size_t first = line.find('\t'), second = line.find('\t', first + 1);
        if (second != std::string::npos)
            inputs.emplace(line.substr(0, first), line.substr(first + 1, second - first - 1));
    }
    return inputs;
}

Normalised normalise(std::string_view text, const std::string& name, bool system_verilog,
                     const OpenInputs& open_inputs, const Modules& modules,
                     const std::vector<InoutFit>& inout_fits, const PinPorts& pins) {
    const auto of = [&](std::string_view source) {
        return Normaliser{source, name, open_inputs, modules, inout_fits, pins}.run(system_verilog);
    };
    if (!system_verilog) return of(text);
    const WithoutAssertions without = without_assertions(text);
    Normalised result = of(without.text);
    if (without.line)
        result.changes.push_back(
            fmt::format("{}:{}: left out the concurrent assertions, which Quartus ignores", name,
                        without.line));
    return result;
}

}  // namespace sim::project
