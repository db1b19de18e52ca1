#include "sim/verilog/quartus/words.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>
#include <regex>
#include <sstream>

#include <fmt/format.h>

namespace sim::project {

std::string line_of(const Message& message) {
    const std::string number = message.number ? fmt::format("{}: ", message.number) : "";
    return (message.file.empty() ? "" : message.place() + ": ") + number + message.text;
}

namespace {

// What the arrow of the source's line points at: "    3 | foo bar" and "      | ^~~".
std::string pointed_at(std::string_view after) {
    std::istringstream lines{std::string{after}};
    std::string line, before;
    for (unsigned n = 0; n < 6 && std::getline(lines, line); ++n, before = line) {
        const std::size_t bar = line.find('|'), arrow = line.find('^');
        if (bar == std::string::npos || arrow == std::string::npos || arrow < bar) continue;
        if (before.size() <= arrow) return {};
        const std::size_t end = line.find_last_of("^~");
        return before.substr(arrow, end + 1 - arrow);
    }
    return {};
}

std::string suggestion(std::string_view after) {
    static const std::string SAID = "Suggested alternative: '";
    const std::size_t line = after.substr(0, 300).find(SAID);
    if (line == std::string_view::npos) return {};
    const std::size_t begin = line + SAID.size();
    return fmt::format("; is it {}?", after.substr(begin, after.find('\'', begin) - begin));
}

struct Rule {
    const char* pattern;
    unsigned number;   // 0: not known
    const char* text;  // {0}: the first group
};

// What is between quotes in Verilator's errors is the name.
const Rule RULES[] = {
    {"Cannot find file containing module: 'de1sim_lacks_([^']*)'", 0,
     "the design sets {0} of this IP, which is not modelled; leave it at its default, or write "
     "what it does in Verilog"},
    {"Cannot find file containing (?:module|interface): '([^']*)'", 12006,
     "no file defines module {0}, which is instanced here; add its file to the project"},
    {"Can't find definition of (?:variable|scope/variable|parameter): '([^']*)'", 10161,
     "{0} is not declared"},
    {"Can't find definition of task/function: '([^']*)'", 10161,
     "no task or function {0} is declared"},
    {"Can't find definition of '([^']*)' in dotted", 10207, "there is nothing of the name {0}"},
    {"Pin not found: '__pinNumber([0-9]+)'", 12002,
     "the instance has more connections than the module has ports: {0}"},
    {"Pin not found: '([^']*)'", 12002, "the module that is instanced has no port {0}"},
    {"Parameter pin not found: '([^']*)'", 0, "the module that is instanced has no parameter {0}"},
    {"Parameter not found: '([^']*)'", 0, "the module that is instanced has no parameter {0}"},
    {"Duplicate pin connection: '([^']*)'", 0, "{0} is connected twice; leave one out"},
    {"Procedural assignment to wire, perhaps intended var.*: '([^']*)'", 10137,
     "{0} is a wire, and is assigned in a block; declare it as reg"},
    {"Continuous assignment to reg, perhaps intended wire.*: '([^']*)'", 10219,
     "{0} is a reg, and is assigned by `assign`; declare it as wire, or assign it in a block"},
    {"Duplicate declaration of [a-z]*: '([^']*)'", 10149, "{0} is declared twice"},
    {"Assigning to (?:input/const variable|const ref variable): '([^']*)'", 10231,
     "input {0} is assigned; an input can only be read"},
    {"Cannot find include file: '?([^' ]*)'?", 10054, "the file {0} that is included is not there"},
    {"Define or directive not defined: '([^']*)'", 0,
     "the macro {0} is not defined (VERILOG_MACRO in the .qsf, or -D)"},
    {"Illegal bit or array select", 0, "bits are selected of something that has one bit alone"},
    {"Expecting expression to be constant", 0, "a constant is expected here"},
    {"Unsupported: (.*)", 0, "this cannot be simulated ({0}); write it in another way"},
    {"Can't resolve module reference: '([^']*)'", 12006, "no file defines module {0}"},
};

std::string syntax_error(const std::string& what, std::string_view after) {
    std::string near = pointed_at(after), expected;
    const std::size_t expecting = what.find("expecting ");
    if (expecting != std::string::npos)
        expected = fmt::format("; expected {}", what.substr(expecting + 10));
    if (near.empty()) {
        const std::size_t unexpected = what.find("unexpected ");
        near = unexpected == std::string::npos
                   ? ""
                   : what.substr(unexpected + 11, what.find(',', unexpected) - unexpected - 11);
    }
    return near.empty()
               ? "Quartus error 10170: syntax error" + expected
               : fmt::format("Quartus error 10170: syntax error near \"{}\"{}", near, expected);
}

// "top.v:3:5: text" in its parts; false: it has no place.
bool split(const std::string& output, std::string& place, std::string& text) {
    static const std::regex PLACE{"^(.*?):([0-9]+):[0-9]+: (.*)$"};
    std::smatch m;
    if (!std::regex_match(output, m, PLACE)) return false;
    place = m[1].str() + ":" + m[2].str();
    text = m[3];
    return true;
}

}  // namespace

std::string error_in_our_words(const std::string& error, std::string_view after) {
    std::string place, text;
    if (!split(error, place, text)) return error;
    if (text.find("syntax error") != std::string::npos)
        return fmt::format("{}: {}", place, syntax_error(text, after));
    for (const Rule& rule : RULES) {
        std::smatch m;
        if (!std::regex_search(text, m, std::regex{rule.pattern})) continue;
        const std::string name = m.size() > 1 ? m[1].str() : "";
        return fmt::format("{}: {}{}{}", place,
                           rule.number ? fmt::format("Quartus error {}: ", rule.number) : "",
                           fmt::format(fmt::runtime(rule.text), name), suggestion(after));
    }
    static const std::regex STANDARD{" *\\(IEEE [^)]*\\)"};
    return fmt::format("{}: {}", place, std::regex_replace(text, STANDARD, ""));
}

namespace {

Message made(unsigned number, std::string text) { return {number, {}, 0, std::move(text)}; }

unsigned long number_of(const std::string& text) { return std::strtoul(text.c_str(), nullptr, 10); }

Message of_port(const std::smatch& m) {
    const bool out = m[1] == "Output";
    const unsigned long port = number_of(m[3]), wire = number_of(m[4]);
    const char* what = wire > port ? out ? "the upper bits of what it is connected with get 0"
                                         : "the upper bits of what it is connected with are cut"
                       : out       ? "its upper bits go nowhere"
                                   : "its upper bits are 0";
    return made(wire > port ? 12010
                : out       ? 12030
                            : 12020,
                fmt::format("port {} has {} bits and is connected with {}: {}", m[2].str(), port,
                            wire, what));
}

// By the code of the warning.
Message warning(const std::string& code, const std::string& text) {
    const auto matches = [&](const char* pattern, std::smatch& m) {
        static std::map<const char*, std::regex> known;  // to make one takes longer than to use it
        const auto [found, is_new] = known.try_emplace(pattern);
        if (is_new) found->second = pattern;
        return std::regex_search(text, m, found->second);
    };
    std::smatch m;
    if (code == "IMPLICIT" && matches("implicitly: '([^']*)'", m))
        return made(10236, fmt::format("{} is not declared, so it is a wire of one bit of its own; "
                                       "is the name right?",
                                       m[1].str()));
    if (code.rfind("WIDTH", 0) == 0) {  // WIDTHTRUNC and WIDTHEXPAND from 5.010 on
        if (matches("Operator ASSIGN.* expects ([0-9]+) bits on the Assign RHS, but .* generates "
                    "([0-9]+)(?: or ([0-9]+))? bits",
                    m) &&
            number_of(m[m[3].matched ? 3 : 2]) > number_of(m[1]))
            return made(10230,
                        fmt::format("a value of {} bits is cut to {}", m[2].str(), m[1].str()));
        if (matches("^(Input|Output|Inout) port connection '([^']*)' expects ([0-9]+) bits on .* "
                    "generates ([0-9]+) bits",
                    m))
            return of_port(m);
        if (matches("Bit extraction of array\\[([0-9:]*)\\] requires ([0-9]+) bit index, not "
                    "([0-9]+) bits",
                    m) &&
            number_of(m[3]) < number_of(m[2]))
            return made(10027, fmt::format("an index of {} bits does not reach all words of the "
                                           "array [{}]",
                                           m[3].str(), m[1].str()));
    }
    if (code == "CMPCONST" || code == "UNSIGNED")
        return made(10037,
                    "the comparison always has the same result: the other value can never "
                    "be reached");
    if (code == "SELRANGE" && matches("range: ([0-9]+)(?::[0-9]+)? outside .*?([0-9]+:[0-9]+)", m))
        return made(
            10232, fmt::format("{} is an index outside of the range [{}]", m[1].str(), m[2].str()));
    return made(0, {});
}

}  // namespace

Messages warnings_in_our_words(const std::string& output) {
    Messages messages;
    std::istringstream lines{output};
    static const std::string MARK = "%Warning-";
    for (std::string line; std::getline(lines, line);) {
        if (line.compare(0, MARK.size(), MARK) != 0) continue;
        const std::size_t colon = line.find(": ");
        if (colon == std::string::npos) continue;
        std::string place, text;
        if (!split(line.substr(colon + 2), place, text)) continue;
        Message message = warning(line.substr(MARK.size(), colon - MARK.size()), text);
        const std::size_t number = place.rfind(':');
        message.file = place.substr(0, number);
        message.line = static_cast<unsigned>(number_of(place.substr(number + 1)));
        if (message.number && message.file.compare(0, 5, "data/") != 0 &&
            message.file.compare(0, 7, "source/") != 0 &&
            message.file.find(" in Verilog") == std::string::npos)
            messages.push_back(std::move(message));
    }
    return messages;
}

}  // namespace sim::project
