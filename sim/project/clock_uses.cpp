#include "sim/project/clock_uses.h"

#include <cstdlib>
#include <string_view>

namespace sim::project {

namespace {

using Node = pugi::xml_node;

std::string_view kind(const Node& node) { return node.name(); }

std::string text(const Node& node, const char* attribute) {
    return node.attribute(attribute).value();
}

Node module_of(Node node) {
    while (node && kind(node) != "module") node = node.parent();
    return node;
}

// 32'h1f
std::optional<int> number(const Node& constant) {
    const std::string name = text(constant, "name");
    const std::size_t digits = name.find_last_of('h');
    if (kind(constant) != "const" || digits == std::string::npos) return {};
    return static_cast<int>(std::strtol(name.c_str() + digits + 1, nullptr, 16));
}

Node second(const Node& node) { return node.first_child().next_sibling(); }

// The variable or connection among the children of `parent` that belongs to `other`, by its name,
// or by its place in a list of ports.
Node counterpart(const Node& parent, const char* kind_wanted, const char* index, const Node& other,
                 const char* index_of_other) {
    if (const Node named =
            parent.find_child_by_attribute(kind_wanted, "name", other.attribute("name").value()))
        return named;
    const char* const place = other.attribute(index_of_other).value();
    return *place ? parent.find_child_by_attribute(kind_wanted, index, place) : Node{};
}

bool has_tap(const Node& module) {
    for (const auto& found : module.select_nodes(".//instance"))
        if (text(found.node(), "defName").compare(0, 14, "de1sim_pll_tap") == 0) return true;
    return false;
}

}  // namespace

ClockUses::ClockUses(const Node& netlist) {
    for (const Node& type : netlist.child("typetable").children()) {
        if (kind(type) != "basicdtype") continue;
        const int left = type.attribute("left").as_int(), right = type.attribute("right").as_int();
        widths_[text(type, "id")] = std::abs(left - right) + 1;
    }
    for (const Node& module : netlist.children("module")) {
        modules_[text(module, "name")] = module;
        for (const auto& found : module.select_nodes(".//instance"))
            instances_[text(found.node(), "defName")].push_back(found.node());
        for (const auto& found : module.select_nodes(".//var"))
            variables_.emplace(
                std::pair{found.node().parent().hash_value(), text(found.node(), "name")},
                found.node());
        for (const auto& found : module.select_nodes(".//varref"))
            if (const Node var = variable_of(found.node()))
                references_[var.hash_value()].push_back(found.node());
        for (const auto& found : module.select_nodes(".//varxref"))
            seen_from_outside_.insert(text(found.node(), "name"));
    }
}

// 0: not known.
int ClockUses::width_of(const Node& expression) const {
    const auto width = widths_.find(text(expression, "dtype_id"));
    return width == widths_.end() ? 0 : width->second;
}

// That a reference means: of its block, or of one around it.
ClockUses::Node ClockUses::variable_of(const Node& reference) const {
    const std::string name = text(reference, "name");
    for (Node scope = reference.parent(); scope; scope = scope.parent()) {
        const auto var = variables_.find({scope.hash_value(), name});
        if (var != variables_.end()) return var->second;
        if (kind(scope) == "module") break;
    }
    return {};
}

// The bits of what is assigned to, from the right; empty: not known.
std::vector<ClockUses::Net> ClockUses::nets_of(const Node& target) const {
    std::vector<Net> nets;
    if (kind(target) == "varref") {
        const Node var = variable_of(target);
        for (int bit = 0; var && bit < width_of(target); ++bit) nets.push_back({var, bit});
    } else if (kind(target) == "sel") {
        const auto lsb = number(second(target)), width = number(second(target).next_sibling());
        const std::vector<Net> all = nets_of(target.first_child());
        if (!lsb || !width || *lsb + *width > static_cast<int>(all.size())) return {};
        nets.assign(all.begin() + *lsb, all.begin() + *lsb + *width);
    } else if (kind(target) == "concat") {
        nets = nets_of(second(target));
        const std::vector<Net> upper = nets_of(target.first_child());
        if (nets.empty() || upper.empty()) return {};
        nets.insert(nets.end(), upper.begin(), upper.end());
    }
    return nets;
}

class ClockUses::Path {
public:
    explicit Path(const ClockUses& design) : design_{design} {}

    void add(const Net& net) {
        if (seen_.emplace(net.var.hash_value(), net.bit).second) left_.push_back(net);
    }
    // False: something else may see it.
    bool follow() {
        while (!left_.empty()) {
            const Net net = left_.back();
            left_.pop_back();
            if (text(net.var, "dir") == "inout" ||
                design_.seen_from_outside_.count(text(net.var, "name")))
                return false;
            if (text(net.var, "dir") == "output" && !leave(net)) return false;
            const auto references = design_.references_.find(net.var.hash_value());
            if (references == design_.references_.end()) continue;
            for (const Node& reference : references->second)
                if (!pass(net, reference)) return false;
        }
        return true;
    }
    Use use;

private:
    // The bit that `net` is of what is assigned or connected there.
    bool go_on(const Node& target, int bit) {
        const std::vector<Net> nets = design_.nets_of(target);
        if (bit >= static_cast<int>(nets.size())) return false;
        add(nets[static_cast<std::size_t>(bit)]);
        return true;
    }

    // By an output of its module, to where that is instanced.
    bool leave(const Net& net) {
        const Node module = module_of(net.var);
        if (module.attribute("topModule").as_bool()) {
            use.pins.emplace_back(text(net.var, "name"), net.bit);
            return true;
        }
        const auto instances = design_.instances_.find(text(module, "name"));
        if (instances == design_.instances_.end()) return true;
        for (const Node& instance : instances->second) {
            const Node port = counterpart(instance, "port", "portIndex", net.var, "pinIndex");
            if (port.first_child() && !go_on(port.first_child(), net.bit)) return false;
        }
        return true;
    }

    // Where it is read, or is assigned to.
    bool pass(const Net& net, const Node& reference) {
        Node value = reference;
        int bit = net.bit;
        if (kind(value.parent()) == "sel" && value.parent().first_child() == value) {
            value = value.parent();
            const auto lsb = number(second(value)), width = number(second(value).next_sibling());
            if (!lsb || !width) return false;
            if (net.bit < *lsb || net.bit >= *lsb + *width) return true;
            bit -= *lsb;
        }
        Node where = value.parent();
        if (is_target(value)) return true;
        if (kind(where) == "senitem" && text(where, "edgeType") == "POS") {
            const bool locks = text(module_of(where), "origName") == "de1sim_pll_lock";
            use.locks |= locks;
            use.rises |= !locks;
            return true;
        }
        if (kind(where) == "and" && design_.width_of(where) == 1 && has_tap(module_of(where))) {
            value = where;
            where = where.parent();
        }
        if (kind(where) == "contassign") return go_on(second(where), bit);
        if (kind(where) != "port" || text(where, "direction") != "in") return false;
        const auto inside = design_.modules_.find(text(where.parent(), "defName"));
        if (inside == design_.modules_.end()) return false;
        const Node var = counterpart(inside->second, "var", "pinIndex", where, "portIndex");
        if (!var) return false;
        add({var, bit});
        return true;
    }

    // It is what is driven: the left side of an assignment, or connected with an output.
    static bool is_target(Node value) {
        while (kind(value.parent()) == "concat") value = value.parent();
        const Node use = value.parent();
        if (kind(use) == "contassign") return second(use) == value;
        return kind(use) == "port" && text(use, "direction") == "out";
    }

    const ClockUses& design_;
    std::set<std::pair<std::size_t, int>> seen_;
    std::vector<Net> left_;
};

std::optional<ClockUses::Use> ClockUses::of_tap(const std::string& tap) const {
    Path path{*this};
    const auto taps = instances_.find(tap);
    if (taps == instances_.end()) return {};
    for (const Node& instance : taps->second) {
        const Node port = instance.find_child_by_attribute("port", "name", "clk");
        const std::vector<Net> nets = nets_of(port.first_child());
        if (port.first_child() && nets.size() != 1) return {};
        for (const Net& net : nets) path.add(net);
    }
    return path.follow() ? std::optional{path.use} : std::nullopt;
}

std::optional<ClockUses::Use> ClockUses::of_input(const Node& port) const {
    Path path{*this};
    path.add({port, 0});
    return path.follow() ? std::optional{path.use} : std::nullopt;
}

}  // namespace sim::project
