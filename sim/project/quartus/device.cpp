#include "sim/project/quartus/device.h"

#include <functional>
#include <string_view>

#include <fmt/format.h>

namespace sim::project {

namespace {

constexpr unsigned DEEPEST_HIERARCHY = 100;

struct Largest {
    unsigned long long bits = 0, all = 0;
    const Variable* variable = nullptr;
};

using Counts = std::function<bool(const NetModule&, const Variable&)>;

void count(const Netlist& netlist, const std::string& key, const Counts& counts, Largest& largest,
           unsigned depth) {
    const auto module = netlist.modules().find(key);
    if (module == netlist.modules().end() || depth > DEEPEST_HIERARCHY) return;
    for (const Variable& v : module->second.variables) {
        if (!v.is_array || v.is_local || v.is_parameter || !counts(module->second, v)) continue;
        const unsigned long long bits = v.width * v.words;
        largest.all += bits;
        if (bits > largest.bits || !largest.variable) {
            largest.bits = bits;
            largest.variable = &v;
        }
    }
    for (const Instance& i : module->second.instances)
        count(netlist, i.of, counts, largest, depth + 1);
}

Largest count(const Netlist& netlist, const Counts& counts) {
    Largest largest;
    for (const auto& [key, module] : netlist.modules())
        if (module.is_top) count(netlist, key, counts, largest, 0);
    return largest;
}

bool assigns(const pugi::xml_node& node, const std::string& array) {
    if (is_node(node, "assign") || is_node(node, "assigndly")) {
        pugi::xml_node target = node.first_child().next_sibling();
        while (is_node(target, "sel") || is_node(target, "arraysel")) target = target.first_child();
        return target.attribute("name").value() == array;
    }
    for (const pugi::xml_node& child : node.children())
        if (assigns(child, array)) return true;
    return false;
}

// Assigned in a block with several edges, both by the reset and at the clock.
bool has_reset(const NetModule& module, const Variable& v) {
    for (const pugi::xml_node& block : module.blocks) {
        const pugi::xml_node list = block.child("sentree");
        const auto edges = list.select_nodes("senitem[@edgeType='POS' or @edgeType='NEG']");
        pugi::xml_node choice = list.next_sibling();
        if (is_node(choice, "begin")) choice = choice.first_child();
        const pugi::xml_node one = choice.first_child().next_sibling();
        if (edges.size() > 1 && is_node(choice, "if") && assigns(one, v.name) &&
            assigns(one.next_sibling(), v.name))
            return true;
    }
    return false;
}

}  // namespace

Messages register_errors(const Netlist& netlist, const BoardDescription& board) {
    const Largest found = count(netlist, [](const NetModule& module, const Variable& v) {
        return module.is_own && v.reads > 0 && has_reset(module, v);
    });
    if (!board.registers || found.all <= board.registers) return {};
    return {{276003, found.variable->place.file, found.variable->place.line,
             fmt::format("{} is cleared by a reset, which no memory can be, so it takes registers: "
                         "{} of the chip's {}; leave the reset out, or clear a word per clock",
                         found.variable->name, found.all, board.registers)}};
}

Messages memory_warnings(const Netlist& netlist, const BoardDescription& board) {
    const Largest found = count(netlist, [](const NetModule&, const Variable& v) {
        return v.reads > 0 && !v.drivers.empty();
    });
    if (!board.memory_bits || found.all <= board.memory_bits) return {};
    return {
        {170048, found.variable->place.file, found.variable->place.line,
         fmt::format("the design's memories have {} bits, {} of them in {}, and the chip has {} "
                     "({}): Quartus cannot fit them",
                     found.all, found.bits, found.variable->name, board.memory_bits,
                     board.memory_blocks)}};
}

}  // namespace sim::project
