#include "sim/project/quartus/netlist_reader.h"

#include <sstream>

#include <fmt/format.h>

namespace sim::project {

using Node = pugi::xml_node;

namespace {

std::string text_of_node(const Node& node) {
    std::ostringstream text;
    for (const Node& child : node.children()) {
        text << child.name() << child.attribute("name").value() << '(';
        text << text_of_node(child) << ')';
    }
    return text.str();
}

}  // namespace

// Walks through one module.
class NetlistReader {
public:
    NetlistReader(const Netlist& netlist, NetModule& module, const Node& node)
        : netlist_{netlist}, module_{module} {
        enter(node);
        items(node);
    }

private:
    void enter(const Node& node) {
        scopes_.emplace_back();
        for (const Node& var : node.children("var")) declare(var, scopes_.size() > 1);
    }
    void declare(const Node& var, bool nested) {
        Variable v;
        v.name = var.attribute("origName").value();
        v.place = netlist_.place(var);
        v.direction = var.attribute("dir").value();
        const auto type = netlist_.types_.find(var.attribute("dtype_id").value());
        if (type != netlist_.types_.end()) {
            v.width = type->second.width;
            v.words = type->second.words;
            v.left = type->second.left;
            v.right = type->second.right;
            v.is_vector = type->second.is_vector;
            v.is_array = type->second.is_array;
            v.is_integer = type->second.is_integer;
        }
        v.is_parameter = var.attribute("param") || var.attribute("localparam") ||
                         std::string_view{var.attribute("vartype").value()} == "genvar";
        static const std::set<std::string_view> USUAL{
            "", "logic", "bit", "integer", "int", "byte", "time", "genvar", "shortint", "longint"};
        v.has_own_type = !USUAL.count(var.attribute("vartype").value());
        v.is_local = nested && (in_block_ || process_ != 0);
        module_.variables.push_back(std::move(v));
        const std::size_t n = module_.variables.size() - 1;
        scopes_.back()[var.attribute("name").value()] = n;
        if (var.attribute("pinIndex") || (!nested && var.attribute("dir")))
            module_.ports[var.attribute("origName").value()] = n;
        if (const auto number = var.attribute("pinIndex"))
            module_.port_names[fmt::format("__pinNumber{}", number.value())] =
                var.attribute("origName").value();
    }
    Variable* variable(const Node& ref) const {
        const std::string name = ref.attribute("name").value();
        for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope)
            if (const auto found = scope->find(name); found != scope->end())
                return &module_.variables[found->second];
        return nullptr;
    }

    void items(const Node& node) {
        for (const Node& item : node.children()) {
            const std::string_view name = item.name();
            if (name == "begin" || name == "generate") {
                enter(item);
                items(item);
                scopes_.pop_back();
            } else if (name == "contassign") {
                process(item, Driver::Kind::ASSIGN);
            } else if (name == "always") {
                module_.blocks.push_back(item);
                process(item, Driver::Kind::ALWAYS);
            } else if (name == "initial" && is_constant_assign(item)) {
                process(item.first_child(), Driver::Kind::ASSIGN);
            } else if (name == "initial" || name == "initialstatic") {
                process(item, Driver::Kind::INITIAL);
            } else if (name == "func" || name == "task") {
                process(item, Driver::Kind::TASK);
            } else if (name == "instance") {
                instance(item);
            } else if (name == "pull") {
                pull(item);
            } else if (name != "var") {
                read(item);
            }
        }
    }

    // What has become of `assign` of a constant, whose sign is the place of both.
    static bool is_constant_assign(const Node& initial) {
        const Node assign = initial.first_child();
        return is_node(assign, "assign") && std::string_view{assign.attribute("loc").value()} ==
                                                initial.attribute("loc").value();
    }

    void process(const Node& item, Driver::Kind kind) {
        process_ = ++processes_;
        kind_ = kind;
        if (kind == Driver::Kind::ASSIGN) {
            assignment(item, false);
        } else {
            enter(item);
            loops_.clear();
            find_loops(item);
            for (const Node& child : item.children()) statement(child);
            scopes_.pop_back();
        }
        process_ = 0;
    }

    void find_loops(const Node& node) {
        for (const Node& child : node.children()) {
            if (is_node(child, "while"))  // its second part is the condition
                add_names(child.first_child().next_sibling());
            find_loops(child);
        }
    }
    void add_names(const Node& node) {
        if (is_node(node, "varref")) loops_.insert(node.attribute("name").value());
        for (const Node& child : node.children()) add_names(child);
    }
    bool has_loop_variable(const Node& node) const {
        if (is_node(node, "varref")) return loops_.count(node.attribute("name").value()) > 0;
        for (const Node& child : node.children())
            if (has_loop_variable(child)) return true;
        return false;
    }

    void statement(const Node& node) {
        const std::string_view name = node.name();
        if (name == "var") return;
        if (name == "assign" || name == "assigndly") return assignment(node, name == "assign");
        if (name == "varref") return read(node);
        if (name == "taskref" || name == "funcref" || name == "readmem") return call(node);
        if (name == "case") return cases(node);
        const bool scope = name == "begin";
        if (scope) enter(node);
        for (const Node& child : node.children()) statement(child);
        if (scope) scopes_.pop_back();
    }

    // What drives in a default that is never reached is no driver; of an enumeration it is not
    // known whether it is reached.
    void cases(const Node& node) {
        const bool before = uncertain_, full = is_full(node);
        for (const Node& item : node.children()) {
            uncertain_ = before || (full && is_default(item));
            statement(item);
        }
        uncertain_ = before;
    }
    bool is_full(const Node& node) const {
        constexpr unsigned MOST_BITS_OF_CASE = 16;
        Node of = node.first_child();
        while (is_node(of, "extend")) of = of.first_child();
        const auto type = netlist_.types_.find(of.attribute("dtype_id").value());
        if (type == netlist_.types_.end()) return false;
        if (const Variable* v = is_node(of, "varref") ? variable(of) : nullptr;
            v && v->has_own_type)
            return true;  // an enumeration
        std::set<long long> values;
        for (const Node& item : node.children("caseitem"))
            for (const Node& part : item.children())
                if (const long long value = constant(part); value >= 0) values.insert(value);
        return type->second.width <= MOST_BITS_OF_CASE &&
               values.size() >= (std::size_t{1} << type->second.width);
    }
    static bool is_default(const Node& item) {
        static const std::set<std::string_view> STATEMENTS{"assign", "assigndly", "begin", "case",
                                                           "if",     "stmtexpr",  "while"};
        return is_node(item, "caseitem") && STATEMENTS.count(item.first_child().name()) > 0;
    }

    // Which arguments it assigns is not looked at.
    void call(const Node& node) {
        const Driver::Kind kind = kind_;
        read(node);
        if (kind != Driver::Kind::INITIAL) kind_ = Driver::Kind::TASK;
        place_ = netlist_.place(node);
        high_z_ = false;
        drive_all(node);
        kind_ = kind;
    }

    void assignment(const Node& node, bool blocking) {
        const Node value = node.first_child(), target = value.next_sibling();
        read(value);
        blocking_ = blocking;
        high_z_ = has_z(value);
        is_any_ = is_node(value, "const") && std::string_view{value.attribute("name").value()}.find(
                                                 'x') != std::string_view::npos;
        value_ = kind_ == Driver::Kind::ASSIGN ? text_of_node(node) : "";
        place_ = netlist_.place(node);
        drive(target);
    }

    void read(const Node& node) {
        if (is_node(node, "varref")) {
            if (Variable* v = variable(node)) {
                ++v->reads;
                v->readers.insert(process_ ? process_ : ++processes_);
            }
        }
        for (const Node& child : node.children()) read(child);
    }

    // ---- Targets ----

    Driver driver() const {
        Driver d{};
        d.kind = kind_;
        d.process = process_;
        d.place = place_;
        d.element = -1;
        d.exact = !uncertain_ && !is_any_;
        d.high_z = high_z_;
        d.blocking = blocking_;
        d.value = value_;
        return d;
    }
    void drive(const Node& target) {
        Driver d = driver();
        const Node* base = &target;
        Node inner;
        d.high = ~0u;
        bool part = false;
        // An element's number has bits for the index of each dimension, the last one's first.
        constexpr unsigned INDEX_BITS = 20, MOST_DIMENSIONS = 3;
        unsigned dimensions = 0;
        for (;;) {
            if (is_node(*base, "varref")) break;
            const Node first = base->first_child(), index = first.next_sibling();
            if (is_node(*base, "sel") && !part) {
                read(index);
                const long long low = constant(index), width = constant(index.next_sibling());
                if (low >= 0 && width > 0) {
                    d.low = static_cast<unsigned>(low);
                    d.high = static_cast<unsigned>(low + width - 1);
                } else if (has_loop_variable(index)) {
                    d.exact = false;
                }
                part = true;
            } else if (is_node(*base, "sel")) {
                read(index);
                d.exact = false;
            } else if (is_node(*base, "arraysel")) {
                read(index);
                const long long at = constant(index);
                if (at < 0 || dimensions == MOST_DIMENSIONS) d.exact = false;
                if (d.exact)
                    d.element =
                        static_cast<long>(at << INDEX_BITS * dimensions | std::max(d.element, 0L));
                ++dimensions;
            } else if (is_node(*base, "concat") || is_node(*base, "extend") ||
                       is_node(*base, "extends")) {
                if (part) return drive_all(*base);
                for (const Node& child : base->children()) drive(child);
                return;
            } else {
                return drive_all(*base);
            }
            inner = first;
            base = &inner;
        }
        if (Variable* v = variable(*base)) add(*v, d);
    }
    void drive_all(const Node& node) {
        if (is_node(node, "varref")) {
            Driver d = driver();
            d.high = ~0u;
            d.exact = false;
            if (Variable* v = variable(node)) add(*v, d);
        }
        for (const Node& child : node.children()) drive_all(child);
    }
    void add(Variable& v, Driver d) {
        if (d.high >= v.width) d.high = v.width - 1;
        if (v.is_array && d.element < 0) d.exact = false;
        if (loops_.count(v.name) && kind_ != Driver::Kind::ASSIGN) v.is_loop_variable = true;
        if (port_) {
            d.of = instance_->of;
            d.port = port_->port;
            d.instance = instance_->name;
        }
        v.drivers.push_back(std::move(d));
    }

    void instance(const Node& item) {
        Instance i{item.attribute("name").value(),
                   item.attribute("defName").value(),
                   netlist_.place(item),
                   {}};
        process_ = ++processes_;
        kind_ = Driver::Kind::INSTANCE;
        loops_.clear();
        blocking_ = high_z_ = is_any_ = false;
        value_.clear();
        const bool several = item.child("range");
        for (const Node& port : item.children("port")) {
            i.connections.push_back({port.attribute("name").value(),
                                     port.attribute("direction").value(), !port.first_child()});
            instance_ = &i;
            port_ = &i.connections.back();
            place_ = netlist_.place(port);
            for (const Node& expression : port.children()) {
                if (port_->direction == "in" || port_->direction == "inout") read(expression);
                high_z_ = port_->direction == "inout";
                if (port_->direction == "in") continue;
                if (several)
                    drive_all(expression);
                else
                    drive(expression);
            }
            port_ = nullptr;
        }
        process_ = 0;
        module_.instances.push_back(std::move(i));
    }

    void pull(const Node& item) {
        for (const auto& ref : item.select_nodes(".//varref"))
            if (Variable* v = variable(ref.node())) v->has_pull = true;
    }

    const Netlist& netlist_;
    NetModule& module_;
    std::vector<std::map<std::string, std::size_t>> scopes_;
    std::set<std::string> loops_;  // variables that a condition of a loop names
    unsigned processes_ = 0, process_ = 0;
    Driver::Kind kind_ = Driver::Kind::ASSIGN;
    bool blocking_ = false, high_z_ = false, in_block_ = false, uncertain_ = false;
    bool is_any_ = false;  // the value is x, which Quartus makes of it what it likes
    std::string value_;
    Place place_;
    const Instance* instance_ = nullptr;
    const Connection* port_ = nullptr;
};

void read_module(const Netlist& netlist, NetModule& module, const Node& node) {
    NetlistReader{netlist, module, node};
}

}  // namespace sim::project
