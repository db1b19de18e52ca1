#include "sim/vhdl/ghdl_text.h"

#include <algorithm>
#include <sstream>

namespace sim::project {

namespace {

std::vector<std::string> parts_of(const std::string& list, char separator) {
    std::vector<std::string> parts;
    std::istringstream in{list};
    for (std::string part; std::getline(in, part, separator);) parts.push_back(trimmed(part));
    return parts;
}
}  // namespace

std::string trimmed(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(' '), end = text.find_last_not_of(' ');
    return begin == std::string::npos ? "" : text.substr(begin, end + 1 - begin);
}
std::string name_of(const std::string& atom) { return trimmed(atom.substr(0, atom.find('['))); }

bool is_literal(const std::string& atom) { return atom.find("'b") != std::string::npos; }
std::optional<Passed> passed(const std::string& value) {
    Passed p;
    std::string rest = value;
    if (value[0] == '{' && value.find('{', 1) == std::string::npos && value.back() == '}') {
        p.atoms = parts_of(value.substr(1, value.size() - 2), ',');
    } else {
        if (const std::size_t choice = value.find(" ? "); choice != std::string::npos) {
            p.condition = value.substr(0, choice);
            rest = value.substr(choice + 3);
            const std::size_t colon = rest.find(" : ");
            if (colon == std::string::npos) return {};
            p.atoms = {rest.substr(0, colon), rest.substr(colon + 3)};
        } else {
            p.atoms = {value};
        }
    }
    for (const std::string& atom : p.atoms)
        if (atom.substr(0, atom.find('[')).find_first_of("&|^~+-*/%<>=?(){}!$") !=
            std::string::npos)
            return {};
    return p;
}

// "  assign a = b; // c", "      2'b10: a <= b;", "    a = b;", "  localparam [3:0] a = b;"
std::optional<GhdlAssignment> assignment_in(const std::string& line) {
    const std::size_t end = line.find(';');
    const std::size_t less = line.find(" <= "), equals = line.find(" = ");
    const std::size_t at = std::min(less, equals);
    if (end == std::string::npos || at == std::string::npos || at > end) return {};
    std::size_t begin = line.rfind(' ', at - 1) + 1;
    if (line[at - 1] == ']' || line[at - 1] == ' ') return {};  // memories, escaped names
    GhdlAssignment a{begin, line.substr(begin, at - begin), at == less ? " <= " : " = ", {}, end};
    const std::size_t value = at + a.sign.size();
    a.value = line.substr(value, end - value);
    if (a.sign == " = " && less < end) return {};
    if (a.value.empty()) return {};
    return a;
}

Declarations::Declarations(const std::vector<std::string>& lines) {
    static const std::set<std::string> WORDS{"input", "output", "inout",
                                             "wire",  "reg",    "localparam"};
    for (const std::string& line : lines) {
        std::istringstream in{line};
        std::string word, next;
        in >> word;
        if (word.rfind("(", 0) == 0 && word.size() > 1) word.erase(0, 1);
        if (!WORDS.count(word) || !(in >> next)) continue;
        std::size_t width = 1;
        if (next[0] == '[') {
            width = std::stoul(next.substr(1)) + 1;
            if (!(in >> next)) continue;
        }
        const std::string name = next.substr(0, next.find_first_of(",;)"));
        if (name.empty()) continue;
        widths[name] = width;
        if (word == "inout") inouts.insert(name);
        if (word == "inout" || word == "output") driven.insert(name);
    }
}

std::size_t Declarations::width_of(const std::string& atom) const {
    if (is_literal(atom)) return std::stoul(atom);
    if (const std::size_t open = atom.find('['); open != std::string::npos) {
        const std::size_t colon = atom.find(':');
        if (colon == std::string::npos) return 1;
        const std::size_t right = std::stoul(atom.substr(colon + 1));
        if (atom[colon - 1] == '-') return right;  // [n -: 4]
        return std::stoul(atom.substr(open + 1)) + 1 - right;
    }
    const auto found = widths.find(trimmed(atom));
    return found == widths.end() ? 0 : found->second;
}

}  // namespace sim::project
