#include "sim/vhdl/vhdl_repairs.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "sim/text/lower.h"
#include "sim/verilog/project_error.h"
#include "sim/verilog/tokens.h"

namespace sim::project {

namespace {

const std::string CASE = "\n    case (";

// "01XZ" as 4'b01XZ, 'X' as 1'bX, (7 downto 0 => 'X') as {8{1'bX}}; else a name, as it is.
std::string in_verilog(const std::string& value) {
    static const std::regex SAME{R"(\((\d+) downto 0 => '(.)'\))"};
    if (std::smatch same; std::regex_match(value, same, SAME))
        return fmt::format("{{{}{{1'b{}}}}}", std::stoul(same[1]) + 1, same[2].str());
    if (value[0] != '"' && value[0] != '\'') return value;
    const std::string bits = value.substr(1, value.size() - 2);
    return fmt::format("{}'b{}", bits.size(), bits);
}

// By architecture and signal:
//   with n16_o select n17_o <=
//     n13_o when "10",
//     n9_o when others;
using Others = std::map<std::pair<std::string, std::string>, std::string>;
Others others_of(const std::string& vhdl) {
    Others others;
    std::istringstream lines{vhdl};
    std::string entity, signal;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream in{line};
        std::string first, second, third, fourth;
        in >> first >> second >> third >> fourth;
        if (first == "architecture") entity = lower(fourth);
        if (first == "with" && third == "select") signal = fourth;
        if (const std::size_t when = line.find(" when others;"); when != std::string::npos) {
            const std::size_t value = line.find_first_not_of(' ');
            const std::string text = in_verilog(line.substr(value, when - value));
            if (text.find('(') == std::string::npos) others[{entity, signal}] = text;
        }
    }
    return others;
}

std::string with_others(const std::string& verilog, const std::string& vhdl) {
    const Others others = others_of(vhdl);
    std::string text, module;
    std::string target;  // of the case that is open
    std::istringstream lines{verilog};
    for (std::string line; std::getline(lines, line); text += line + "\n") {
        std::istringstream in{line};
        std::string first, second, third;
        in >> first >> second >> third;
        if (first == "module") module = lower(second);
        if (third == "<=") target = first == "default:" ? "" : second;
        if (first != "endcase" || target.empty()) continue;
        const auto value = others.find({module, target});
        if (value == others.end())
            throw ProjectError{fmt::format(
                "entity {}: GHDL does not write `when others` of a case; a later GHDL may",
                module)};
        text += fmt::format("      default: {} <= {};\n", target, value->second);
    }
    return text;
}

// Those in the parameters of instances are in bits.
std::string with_wide_constants(const std::string& verilog) {
    std::string text;
    std::size_t at = 0;
    for (std::size_t open; (open = verilog.find('"', at)) != std::string::npos;) {
        const std::size_t close = verilog.find('"', open + 1);
        if (close == std::string::npos) break;
        const std::string constant = verilog.substr(open, close + 1 - open);
        const bool bits =
            constant.size() > 34 && constant.find_first_not_of("01XZ", 1) == constant.size() - 1;
        text += verilog.substr(at, open - at) + (bits ? in_verilog(constant) : constant);
        at = close + 1;
    }
    return text + verilog.substr(at);
}

// What lies between the ends of `line` that are given, if it has them; else empty.
std::string between(const std::string& line, const std::string& begin, const std::string& end) {
    if (line.size() < begin.size() + end.size() || line.rfind(begin, 0) != 0 ||
        line.compare(line.size() - end.size(), end.size(), end) != 0)
        return {};
    return line.substr(begin.size(), line.size() - begin.size() - end.size());
}
// Both sides of `middle` in `text`; empty if it is not there.
std::pair<std::string, std::string> split(const std::string& text, const std::string& middle) {
    const std::size_t at = text.find(middle);
    if (at == std::string::npos) return {};
    return {text.substr(0, at), text.substr(at + middle.size())};
}

// One operation: "  assign n = a % b; // smod", or "  n <= a when c else b;" as in VHDL.
std::string operation(const std::string& line) {
    for (const auto& [end, sign] :
         {std::pair{"; // sdiv", " / "}, {"; // srem", " % "}, {"; // smod", " % "}}) {
        const auto [to, value] = split(between(line, "  assign ", end), " = ");
        if (to.empty()) continue;
        const auto [left, right] = split(value, sign);
        const std::string a = fmt::format("$signed({})", left),
                          b = fmt::format("$signed({})", right);
        const std::string result = a + sign + b;
        if (std::string{end} != "; // smod") return fmt::format("  assign {} = {};", to, result);
        return fmt::format("  assign {0} = {1} != 0 && ({2} < 0) != ({3} < 0) ? {1} + {3} : {1};",
                           to, result, a, b);
    }
    if (const std::size_t shift = line.find(") >> ");
        shift != std::string::npos && line.find(" = $signed(") < shift)
        return line.substr(0, shift) + ") >>> " + line.substr(shift + 5);
    const auto [to, value] = split(between(line, "  ", ";"), " <= ");
    const auto [first, choice] = split(value, " when ");
    if (!choice.empty()) {
        const auto [condition, second] = split(choice, " else ");
        return fmt::format("  assign {} = {} ? {} : {};", to, condition, first, second);
    }
    if (const std::string of = between(value, "std_logic_vector(abs ", ")"); !of.empty())
        return fmt::format("  assign {0} = {1} < 0 ? -{1} : {1};", to, of);
    return line;
}

std::string with_operations(const std::string& verilog) {
    std::string text;
    std::istringstream lines{verilog};
    for (std::string line; std::getline(lines, line);) text += operation(line) + "\n";
    return text;
}

bool is_word(std::string_view name) {
    static constexpr std::string_view MORE[] = {
        "cmos",    "highz0",    "highz1", "include", "instance", "liblist", "library",   "nmos",
        "pmos",    "primitive", "pull0",  "pull1",   "rtran",    "rcmos",   "specparam", "strong0",
        "strong1", "table",     "triand", "trior",   "trireg",   "uwire",   "weak0",     "weak1"};
    return is_keyword(name) || std::find(std::begin(MORE), std::end(MORE), name) != std::end(MORE);
}

// GHDL's keywords begin a line, but for those of an event and of the first port.
std::string with_escaped_names(const std::string& verilog) {
    const Tokens tokens = tokens_of(verilog);
    std::set<std::string_view> names;
    const auto begins_line = [&](const Token& token) {
        return token.gap.find('\n') != std::string_view::npos || token.gap.data() == verilog.data();
    };
    for (std::size_t i = 0; i + 1 < tokens.all.size(); ++i) {
        const Token &token = tokens.all[i], &next = tokens.all[i + 1];
        const bool declared = next.is(";") || next.is(",") || next.is(")");
        if (is_word(token.text) && declared && !begins_line(token)) names.insert(token.text);
    }
    const auto is = [&](std::size_t i, std::string_view what) {
        return i < tokens.all.size() && tokens.all[i].is(what);
    };
    std::string text;
    for (std::size_t i = 0; i < tokens.all.size(); ++i) {
        const Token& token = tokens.all[i];
        const bool direction =  // of the first port
            i > 0 && is(i - 1, "(") &&
            (is(i + 1, "[") ||
             (i + 1 < tokens.all.size() && tokens.all[i + 1].kind == Token::Kind::NAME));
        const bool assigned = is(i + 1, "=") || is(i + 1, "<");
        text += token.gap;
        if (names.count(token.text) && !direction && (!begins_line(token) || assigned))
            text += fmt::format("\\{} ", token.text);
        else
            text += token.text;
    }
    return text + std::string{tokens.tail};
}

// Of an instance u with an output q, GHDL calls the net u_q, also where a signal has that name.
// Where the signal is that output, it is the same net.
std::string with_one_net(const std::string& verilog) {
    std::string text;
    std::set<std::string> declared;  // in this module
    std::istringstream lines{verilog};
    for (std::string line; std::getline(lines, line);) {
        std::istringstream in{line};
        std::string first, second, third, fourth;
        in >> first >> second >> third >> fourth;
        if (first == "module") declared.clear();
        if (first == "wire" && !declared.insert(line).second) continue;
        if (first == "assign" && third == "=" && fourth == second + ";") continue;
        text += line + "\n";
    }
    return text;
}

}  // namespace

bool lacks_others(const std::string& verilog) {
    return verilog.find(CASE) != std::string::npos &&
           verilog.find("\n      default: ") == std::string::npos;
}

std::string repaired(const std::string& verilog, const std::string& vhdl) {
    return with_escaped_names(
        with_operations(with_wide_constants(with_others(with_one_net(verilog), vhdl))));
}

}  // namespace sim::project
