#include "sim/project/quartus/loops.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace sim::project {

namespace {

using Node = pugi::xml_node;

std::string name_of(const Node& node) { return node.attribute("name").value(); }

Node without_extension(Node node) {
    while (is_node(node, "extend") || is_node(node, "extends")) node = node.first_child();
    return node;
}

// Of 32 bits with a sign, as loops count.
std::optional<long long> number(const Node& node) {
    const long long value = constant(node);
    if (value < 0) return {};
    const bool is_signed = name_of(node).find("'sh") != std::string::npos;
    return is_signed && value >= 1ll << 31 ? value - (1ll << 32) : value;
}

class Loops {
public:
    Loops(const Netlist& netlist, const LoopLimits& limits) : netlist_{netlist}, limits_{limits} {}

    Messages run() {
        for (const auto& [key, module] : netlist_.modules()) {
            if (!module.is_own) continue;
            for (const Node& item : module.node.children()) find(item, item);
        }
        return std::move(messages_);
    }

private:
    void find(const Node& node, const Node& process) {
        if (is_node(node, "func") || is_node(node, "task") || is_node(node, "jumpblock")) return;
        // Not those of init_text.h.
        if (is_node(node, "begin") && name_of(node).rfind("de1sim_init_", 0) == 0) return;
        if (is_node(node, "while")) look(node, process);
        for (const Node& child : node.children())
            find(child, is_node(child, "always") || is_node(child, "initial") ? child : process);
    }

    // begin: before it; begin: the condition; begin: the body; begin: the step
    void look(const Node& loop, const Node& process) {
        const Node condition = loop.first_child().next_sibling().first_child();
        const Node left = without_extension(condition.first_child()),
                   right = without_extension(condition.first_child().next_sibling());
        const bool is_right = is_node(right, "varref") && !is_node(left, "varref");
        const Node counter = is_right ? right : left, other = is_right ? left : right;
        if (!is_node(counter, "varref") || !other) return;
        Node begin = loop.previous_sibling();
        while (begin && !assigns(begin, name_of(counter))) {
            if (is_assigned(begin, name_of(counter))) return;  // under a condition
            begin = begin.previous_sibling();
        }
        const bool begins = !begin.empty();
        const auto start = begins ? number(begin.first_child()) : std::nullopt;
        const auto step = step_of(loop, name_of(counter));
        if (!step) return;
        const auto end = number(other);
        if (start && end) {
            if (rounds(condition.name(), is_right, *start, *end, *step) > limits_.constant)
                add(10106, loop,
                    fmt::format("the loop has more than {} rounds, which Quartus does not unroll "
                                "(VERILOG_CONSTANT_LOOP_LIMIT)",
                                limits_.constant));
        } else if ((start && is_signal(other, process) && may_exceed(netlist_.width(other))) ||
                   (end && !start && (!begins || reads_variable(begin.first_child())))) {
            add(10119, loop,
                fmt::format("how many rounds the loop has depends on a signal, and is more than {} "
                            "perhaps; count to a constant, with an `if` inside",
                            limits_.non_constant));
        }
    }

    bool may_exceed(unsigned bits) const {
        return bits >= 32 || 1ull << bits > limits_.non_constant;
    }
    static bool assigns(const Node& assign, const std::string& name) {
        const Node target = assign.first_child().next_sibling();
        return is_node(assign, "assign") && is_node(target, "varref") && name_of(target) == name;
    }
    static bool reads_variable(const Node& node) {
        if (is_node(node, "varref")) return true;
        for (const Node& child : node.children())
            if (reads_variable(child)) return true;
        return false;
    }
    // What the process does not assign itself.
    static bool is_signal(const Node& node, const Node& process) {
        return is_node(node, "varref") && !is_assigned(process, name_of(node));
    }
    static bool is_assigned(const Node& node, const std::string& name) {
        if (is_node(node, "assign") || is_node(node, "assigndly"))
            return name_of(node.first_child().next_sibling()) == name;
        for (const Node& child : node.children())
            if (is_assigned(child, name)) return true;
        return false;
    }

    // i = i + 1 or i = i - 1, once in the step or the body, and under no condition.
    static std::optional<long long> step_of(const Node& loop, const std::string& name) {
        std::vector<Node> steps;
        bool is_plain = true;
        for (Node part = loop.first_child().next_sibling().next_sibling(); part;
             part = part.next_sibling())
            find_steps(part, name, true, steps, is_plain);
        if (steps.size() != 1 || !is_plain) return {};
        const Node sum = steps[0].first_child();
        if (!is_node(sum, "add") && !is_node(sum, "sub")) return {};
        const auto a = number(sum.first_child()), b = number(sum.first_child().next_sibling());
        const long long step = is_node(sum, "sub") ? -b.value_or(0) : a.value_or(b.value_or(0));
        return step ? std::optional<long long>{step} : std::nullopt;
    }
    static void find_steps(const Node& node, const std::string& name, bool is_plain,
                           std::vector<Node>& steps, bool& all_plain) {
        if (assigns(node, name)) {
            steps.push_back(node);
            all_plain &= is_plain;
        }
        const bool inside = is_plain && is_node(node, "begin");
        for (const Node& child : node.children()) find_steps(child, name, inside, steps, all_plain);
    }

    // Those up to one more than the limit.
    long long rounds(std::string_view sign, bool is_right, long long at, long long end,
                     long long step) const {
        long long count = 0;
        const auto holds = [&] {
            const long long a = is_right ? end : at, b = is_right ? at : end;
            if (sign == "lt" || sign == "lts") return a < b;
            if (sign == "gt" || sign == "gts") return a > b;
            if (sign == "lte" || sign == "ltes") return a <= b;
            if (sign == "gte" || sign == "gtes") return a >= b;
            return sign == "neq" && a != b;
        };
        for (; count <= limits_.constant && holds(); ++count) at += step;
        return count;
    }

    void add(unsigned message, const Node& node, std::string text) {
        const Place place = netlist_.place(node);
        messages_.push_back({message, place.file, place.line, std::move(text)});
    }

    const Netlist& netlist_;
    const LoopLimits limits_;
    Messages messages_;
};

}  // namespace

Messages loop_errors(const Netlist& netlist, const LoopLimits& limits) {
    return Loops{netlist, limits}.run();
}

}  // namespace sim::project
