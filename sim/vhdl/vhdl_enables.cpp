#include "sim/vhdl/vhdl_enables.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "sim/vhdl/ghdl_text.h"

namespace sim::project {

namespace {

const std::string ON = "__on";

bool has_z(const std::string& atom) {
    return is_literal(atom) && atom.find_first_of("zZ", atom.find('\'')) != std::string::npos;
}

// 4'b01ZZ with its Z as `z` and the others as `other`, or as they are.
std::string replaced(const std::string& literal, char z, char other) {
    const std::size_t digits = literal.find("'b") + 2;
    const std::size_t width = std::stoul(literal);
    std::string bits = literal.substr(digits);
    if (bits == "Z" || bits == "z") bits.assign(width, 'Z');  // fills it
    bits.insert(0, width - std::min(width, bits.size()), '0');
    for (char& bit : bits) bit = bit == 'Z' || bit == 'z' ? z : other ? other : bit;
    return fmt::format("{}'b{}", width, bits);
}

class Enables {
public:
    explicit Enables(const std::vector<std::string>& lines) : lines_{lines}, declared_{lines} {
        for (std::size_t before = ~std::size_t{0}; before != released_.size();) {
            before = released_.size();
            for (const std::string& line : lines_)
                if (const auto a = assignment_in(line); a && may_be_released(a->value))
                    released_.insert(name_of(a->target));
        }
    }

    std::string text() const {
        std::string all;
        for (std::size_t i = 0; i < lines_.size();) {
            std::size_t end = i + 1;  // a block reaches to the next line that is not indented more
            while (begins_block(lines_[i]) && end < lines_.size() &&
                   lines_[end].compare(0, 4, "    ") == 0)
                ++end;
            std::string values, twins;
            bool twin = false;
            for (; i < end; ++i) {
                values += value_line(lines_[i]) + "\n";
                twins += twin_line(lines_[i], twin) + "\n";
            }
            all += values + (twin ? twins : "");
        }
        return all;
    }

private:
    static bool begins_block(const std::string& line) {
        return line.rfind("  always ", 0) == 0 || line.rfind("  initial", 0) == 0;
    }

    bool may_be_released(const std::string& value) const {
        const auto p = passed(value);
        return p && std::any_of(p->atoms.begin(), p->atoms.end(), [&](const std::string& atom) {
                   return has_z(atom) || has_twin(name_of(atom));
               });
    }

    // Not a port: what it reads is what is on the pin.
    bool has_twin(const std::string& name) const {
        return released_.count(name) > 0 && declared_.driven.count(name) == 0;
    }

    std::string value_atom(const std::string& atom) const {
        return has_z(atom) ? replaced(atom, '0', 0) : atom;
    }
    std::string on_atom(const std::string& atom) const {
        if (is_literal(atom)) return replaced(atom, '0', '1');
        const std::string name = name_of(atom);
        if (has_twin(name)) return name + ON + atom.substr(name.size());
        return fmt::format("{{{}{{1'b1}}}}", std::max<std::size_t>(declared_.width_of(atom), 1));
    }
    template <class Atom>
    static std::string rebuilt(const std::string& value, Atom atom) {
        const auto p = passed(value);
        if (!p) return value;
        if (!p->condition.empty())
            return fmt::format("{} ? {} : {}", p->condition, atom(p->atoms[0]), atom(p->atoms[1]));
        if (value[0] != '{') return atom(value);
        std::string list;
        for (const std::string& one : p->atoms) list += (list.empty() ? "" : ", ") + atom(one);
        return "{" + list + "}";
    }

    std::string value_line(const std::string& line) const {
        const auto a = assignment_in(line);
        if (!a || !released_.count(name_of(a->target))) return line;
        const auto value = [this](const std::string& atom) { return value_atom(atom); };
        const std::string all = rebuilt(a->value, value);
        if (!declared_.driven.count(a->target))
            return line.substr(0, a->begin) + a->target + a->sign + all + line.substr(a->end);
        return pins(a->target, a->value);
    }

    // A port, which is driven bit by bit.
    std::string pins(const std::string& port, const std::string& value) const {
        if (is_literal(value)) return fmt::format("  assign {} = {};", port, value);
        const std::size_t width = declared_.widths.at(port);
        const std::string name = name_of(value);
        std::string bits;
        for (std::size_t i = width; i-- > 0;)
            bits += fmt::format("{}{}{}[{}] ? {}[{}] : 1'bZ", bits.empty() ? "" : ", ", name, ON, i,
                                name, i);
        if (width == 1) return fmt::format("  assign {} = {}{} ? {} : 1'bZ;", port, name, ON, name);
        return fmt::format("  assign {} = {{{}}};", port, bits);
    }

    std::string twin_line(const std::string& line, bool& twin) const {
        std::istringstream in{line};
        std::string word, next;
        in >> word >> next;
        if (next[0] == '[') in >> next;
        const std::string declared = next.substr(0, next.find(';'));
        if ((word == "wire" || word == "reg") && released_.count(declared)) {
            twin = true;
            return line.substr(0, line.find(declared)) + declared + ON + ";";
        }
        const auto a = assignment_in(line);
        if (!a || !released_.count(name_of(a->target)) || declared_.driven.count(a->target))
            return line;
        twin = true;
        return line.substr(0, a->begin) + name_of(a->target) + ON + a->sign +
               rebuilt(a->value, [this](const std::string& atom) { return on_atom(atom); }) + ";";
    }

    const std::vector<std::string>& lines_;
    const Declarations declared_;
    std::set<std::string> released_;  // what may be Z
};

}  // namespace

std::string with_enables(const std::vector<std::string>& lines) { return Enables{lines}.text(); }

}  // namespace sim::project
