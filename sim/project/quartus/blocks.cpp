#include "sim/project/quartus/blocks.h"

#include <algorithm>
#include <set>
#include <string_view>

#include <fmt/format.h>

namespace sim::project {

namespace {

using Node = pugi::xml_node;
using NodeNames = std::set<std::string>;

bool is_statement(const Node& node) {
    static const std::set<std::string_view> NAMES{"assign",  "assigndly", "begin",    "case",
                                                  "display", "if",        "stmtexpr", "stop",
                                                  "while",   "finish"};
    return NAMES.count(node.name()) > 0;
}

void add_refs(const Node& node, NodeNames& names) {
    if (is_node(node, "varref")) names.insert(node.attribute("name").value());
    for (const Node& child : node.children()) add_refs(child, names);
}

NodeNames common(const NodeNames& a, const NodeNames& b) {
    NodeNames both;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::inserter(both, both.end()));
    return both;
}

class Blocks {
public:
    Blocks(const Netlist& netlist, const SourceLine& source) : netlist_{netlist}, source_{source} {}

    Messages run() {
        for (const auto& [key, module] : netlist_.modules()) {
            if (!module.is_own) continue;
            module_ = &module;
            for (const Node& block : module.blocks) look(block);
        }
        return std::move(messages_);
    }

private:
    void look(const Node& block) {
        const Place place = netlist_.place(block);
        const Node list = block.child("sentree");
        bool clocked = false;
        for (const Node& item : list.children("senitem")) {
            const std::string edge = item.attribute("edgeType").value();
            clocked |= edge == "POS" || edge == "NEG" || edge == "BOTH";
        }
        any_.clear();
        NodeNames always;
        for (const Node& child : block.children()) {
            if (is_node(child, "sentree")) continue;
            const NodeNames more = assigned(child);
            always.insert(more.begin(), more.end());
        }
        if (clocked) return derived_clock(block, list);
        if (source_(place.file, place.line).find("always_latch") == std::string::npos)
            for (const std::string& name : any_)
                if (!always.count(name) && is_seen(name))
                    add(10240, place,
                        fmt::format("{} keeps its value on some paths through the block, so it is "
                                    "a latch; assign it on all of them",
                                    name));
        if (list) complete(block, list, place);
    }

    // A register as a clock.  What the block also reads is its reset.
    void derived_clock(const Node& block, const Node& list) {
        NodeNames clocks, read;
        add_refs(list, clocks);
        for (const Node& child : block.children())
            if (!is_node(child, "sentree")) add_reads(child, read);
        for (const std::string& name : clocks) {
            const Variable* v = read.count(name) ? nullptr : variable(name);
            if (!v || std::none_of(v->drivers.begin(), v->drivers.end(), [](const Driver& d) {
                    return d.kind == Driver::Kind::ALWAYS && !d.blocking;
                }))
                continue;
            add(332060, v->place,
                fmt::format("{} is a register and a clock; an enable at CLOCK_50 is safer, or "
                            "create_generated_clock in the .sdc",
                            name));
        }
    }

    const Variable* variable(const std::string& name) const {
        const auto found = std::find_if(module_->variables.begin(), module_->variables.end(),
                                        [&](const Variable& v) { return v.name == name; });
        return found == module_->variables.end() ? nullptr : &*found;
    }

    // Outside of the block that assigns it.
    bool is_seen(const std::string& name) const {
        const Variable* v = variable(name);
        if (!v || v->is_local || v->is_loop_variable || v->is_array) return false;
        if (!v->direction.empty()) return true;
        std::set<unsigned> drivers;
        for (const Driver& d : v->drivers) drivers.insert(d.process);
        return !std::includes(drivers.begin(), drivers.end(), v->readers.begin(), v->readers.end());
    }

    // What the block reads, and its list has not.
    void complete(const Node& block, const Node& list, const Place& place) {
        NodeNames listed, read;
        add_refs(list, listed);
        for (const Node& child : block.children())
            if (!is_node(child, "sentree")) add_reads(child, read);
        for (const std::string& name : read) {
            const Variable* v = variable(name);
            if (!v || v->is_local || v->is_parameter || v->is_loop_variable || any_.count(name) ||
                listed.count(name))
                continue;
            add(10235, place,
                fmt::format("{} is read in the block, but is not in its list; the logic depends on "
                            "it all the same (write @(*))",
                            name));
        }
    }
    void add_reads(const Node& node, NodeNames& names) {
        if (is_node(node, "assign") || is_node(node, "assigndly")) {
            add_refs(node.first_child(), names);
            for (const Node& part : node.first_child().next_sibling().children())
                if (!is_node(part, "varref")) add_refs(part, names);
            return;
        }
        if (is_node(node, "varref")) names.insert(node.attribute("name").value());
        for (const Node& child : node.children()) add_reads(child, names);
    }

    // What is assigned on every path through a statement; any_ gets what is on some.
    NodeNames assigned(const Node& node) {
        NodeNames names;
        const auto join = [&](const Node& child) {
            const NodeNames more = assigned(child);
            names.insert(more.begin(), more.end());
        };
        if (is_node(node, "assign") || is_node(node, "assigndly")) {
            add_targets(node.first_child().next_sibling(), names);
            any_.insert(names.begin(), names.end());
        } else if (is_node(node, "if")) {
            const Node then = node.first_child().next_sibling(), other = then.next_sibling();
            const NodeNames a = assigned(then), b = other ? assigned(other) : NodeNames{};
            names = common(a, b);
        } else if (is_node(node, "case")) {
            names = of_case(node);
        } else if (is_node(node, "begin") || is_node(node, "while") || is_node(node, "stmtexpr")) {
            for (const Node& child : node.children()) join(child);
        } else if (is_node(node, "taskref") || is_node(node, "funcref")) {
            add_refs(node, names);
        }
        return names;
    }
    static void add_targets(const Node& target, NodeNames& names) {
        Node at = target;
        while (is_node(at, "sel") || is_node(at, "arraysel")) at = at.first_child();
        if (is_node(at, "varref"))
            names.insert(at.attribute("name").value());
        else
            for (const Node& child : at.children()) add_targets(child, names);
    }

    // ---- Cases ----

    NodeNames of_case(const Node& node) {
        const Place place = netlist_.place(node);
        const std::string text = source_(place.file, place.line);
        const auto has = [&](const char* word) { return text.find(word) != std::string::npos; };
        const bool wild = has("casex") || has("casez") || has("inside");
        Node of = node.first_child();
        while (is_node(of, "extend")) of = of.first_child();
        const unsigned width = std::min(netlist_.width(of), 64u);
        std::set<long long> values;
        bool has_default = false, known = true, first = true;
        NodeNames names;
        for (const Node& item : node.children("caseitem")) {
            NodeNames here;
            bool has_condition = false;
            for (const Node& part : item.children()) {
                if (is_statement(part)) {
                    const NodeNames more = assigned(part);
                    here.insert(more.begin(), more.end());
                    continue;
                }
                has_condition = true;
                const long long value = constant(part);
                known &= value >= 0;
                if (value < 0) continue;
                if (width < 63 && value >> width != 0) {
                    add(10199, netlist_.place(part),
                        "this item of the case can never be met: it has more bits than what is "
                        "compared");
                } else if (!values.insert(value).second) {
                    add(10272, netlist_.place(part),
                        fmt::format("this item of the case ({}) was there before; the first counts",
                                    value));
                }
            }
            has_default |= !has_condition;
            names = first ? here : common(names, here);
            first = false;
        }
        const bool full = has_default || has("unique") || has("priority") || has("full_case") ||
                          (width < 20 && values.size() == (1ull << width));
        if (wild && width >= 32)
            add(10762, place, "the case has too many values to find out whether it is complete");
        else if (!full && known)
            add(10270, place, "the case is not complete, and has no default");
        return full || !known ? names : NodeNames{};
    }

    void add(unsigned number, const Place& place, std::string text) {
        messages_.push_back({number, place.file, place.line, std::move(text)});
    }

    const Netlist& netlist_;
    const SourceLine& source_;
    const NetModule* module_ = nullptr;
    NodeNames any_;
    Messages messages_;
};

}  // namespace

Messages block_warnings(const Netlist& netlist, const SourceLine& line_of_source) {
    return Blocks{netlist, line_of_source}.run();
}

namespace {

class SelfReading {
public:
    explicit SelfReading(const NodeNames& assigned) : assigned_{assigned} {}

    // What is read by a statement before it is assigned for certain.
    void look(const Node& node) {
        if (is_node(node, "sentree")) return;
        if (is_node(node, "assign") || is_node(node, "assigndly")) {
            add_read_value(node.first_child());
            Node target = node.first_child().next_sibling();
            while (is_node(target, "sel") || is_node(target, "arraysel"))
                target = target.first_child();
            if (is_node(target, "varref")) done_.insert(target.attribute("name").value());
            return;
        }
        if (is_node(node, "varref")) return add_read_value(node);
        const NodeNames before = done_;
        for (const Node& child : node.children()) look(child);
        if (is_node(node, "if") || is_node(node, "case")) done_ = before;
    }
    const NodeNames& found() const { return found_; }

private:
    void add_read_value(const Node& value) {
        NodeNames names;
        add_refs(value, names);
        for (const std::string& name : names)
            if (assigned_.count(name) && !done_.count(name)) found_.insert(name);
    }

    const NodeNames& assigned_;
    NodeNames done_, found_;
};

void add_assigned(const Node& node, NodeNames& names) {
    if (is_node(node, "assign") || is_node(node, "assigndly"))
        add_refs(node.first_child().next_sibling(), names);
    for (const Node& child : node.children()) add_assigned(child, names);
}

}  // namespace

std::string self_reading(const Netlist& netlist) {
    std::string names;
    for (const auto& [key, module] : netlist.modules()) {
        if (!module.is_own) continue;
        for (const Node& block : module.blocks) {
            bool clocked = false;
            for (const Node& item : block.child("sentree").children("senitem"))
                clocked |= std::string_view{item.attribute("edgeType").value()} != "CHANGED";
            if (clocked) continue;
            NodeNames assigned, loops;
            add_assigned(block, assigned);
            for (const auto& loop : block.select_nodes(".//while")) add_refs(loop.node(), loops);
            SelfReading reading{assigned};
            for (const Node& child : block.children()) reading.look(child);
            for (const std::string& name : reading.found())
                if (!loops.count(name))
                    names += fmt::format("{}{} ({})", names.empty() ? "" : ", ", name,
                                         netlist.place(block).text());
        }
    }
    return names;
}

}  // namespace sim::project
