#include "sim/project/quartus/drivers.h"

#include <algorithm>

#include <fmt/format.h>

#include "sim/text/lower.h"

namespace sim::project {

namespace {

using DriverKind = Driver::Kind;

bool is_permanent(const Driver& d) {
    return d.kind != DriverKind::INITIAL && d.kind != DriverKind::TASK;
}

// "LEDR[3:0]", as written: bits count from the right end of the range.
std::string bits_of(const Variable& v, unsigned low, unsigned high) {
    if (!v.is_vector || v.is_array || (low == 0 && high + 1 == v.width)) return v.name;
    const bool falls = v.left >= v.right;
    const auto index = [&](unsigned bit) {
        return falls ? v.right + static_cast<int>(bit) : v.right - static_cast<int>(bit);
    };
    return low == high ? fmt::format("{}[{}]", v.name, index(low))
                       : fmt::format("{}[{}:{}]", v.name, index(high), index(low));
}

// A variable that blocks use for themselves: each assigns it by "=", and nobody else reads it.
bool is_scratch(const Variable& v) {
    if (!v.direction.empty()) return false;
    std::set<unsigned> drivers;
    for (const Driver& d : v.drivers) {
        if (d.kind != DriverKind::ALWAYS || !d.blocking) return false;
        drivers.insert(d.process);
    }
    return std::includes(drivers.begin(), drivers.end(), v.readers.begin(), v.readers.end());
}

std::string text_of(const Driver& d) {
    switch (d.kind) {
        case DriverKind::INSTANCE: return fmt::format("by {} of instance {}", d.port, d.instance);
        case DriverKind::ALWAYS: return "by an always block";
        default: return "by an assign";
    }
}

class Conflicts {
public:
    explicit Conflicts(const Netlist& netlist) : netlist_{netlist} {}

    Messages run() {
        for (const auto& [key, module] : netlist_.modules())
            if (module.is_own)
                for (const Variable& v : module.variables) look(v);
        return std::move(messages_);
    }

private:
    bool drives_always(const Driver& d) const {
        if (!is_permanent(d) || !d.exact || d.high_z) return false;
        return d.kind != DriverKind::INSTANCE || netlist_.drives(d.of, d.port) || is_open(d);
    }
    // An output that nothing drives inside is 0, which is a driver, too.
    bool is_open(const Driver& d) const {
        const auto module = netlist_.modules().find(d.of);
        if (module == netlist_.modules().end() || !module->second.is_own) return false;
        const auto port = module->second.ports.find(d.port);
        if (port == module->second.ports.end()) return false;
        const Variable& v = module->second.variables[port->second];
        return v.direction == "output" && v.drivers.empty();
    }
    // A buffer that releases the wire, and drives it at other times.
    static bool is_buffer(const Driver& d) {
        return d.kind == DriverKind::ASSIGN && d.exact && d.high_z &&
               d.value.compare(0, 4, "cond") == 0;
    }

    void look(const Variable& v) {
        if (v.is_loop_variable || v.is_integer || v.is_local || v.is_parameter || is_scratch(v))
            return;
        for (const Driver& d : v.drivers)
            if (v.direction == "input" && is_permanent(d) && d.kind != DriverKind::INSTANCE)
                return add(10231, d.place,
                           fmt::format("input {} is assigned; an input can only be read", v.name));
        std::vector<const Driver*> all;
        for (const Driver& d : v.drivers)
            if (drives_always(d)) all.push_back(&d);
        for (std::size_t b = 1; b < all.size(); ++b)
            for (std::size_t a = 0; a < b; ++a)
                if (meet(*all[a], *all[b])) return refuse(v, *all[a], *all[b]);
        for (const Driver& d : v.drivers)
            for (const Driver* always : all)
                if (is_buffer(d) && meet(d, *always))
                    return add(
                        13076, d.place,
                        fmt::format("{} has a tri-state buffer here, and a driver that never "
                                    "releases it at {}; drive it in one place",
                                    v.name, always->place.text()));
    }

    static bool meet(const Driver& a, const Driver& b) {
        const bool same_text = a.kind == DriverKind::ASSIGN && b.kind == DriverKind::ASSIGN &&
                               a.value == b.value;  // is one driver
        return a.process != b.process && a.element == b.element && !same_text && a.low <= b.high &&
               b.low <= a.high;
    }

    void refuse(const Variable& v, const Driver& a, const Driver& b) {
        const std::string what = bits_of(v, std::max(a.low, b.low), std::min(a.high, b.high));
        const bool open = is_open(a) || is_open(b);
        const bool instance =
            !open && (a.kind == DriverKind::INSTANCE || b.kind == DriverKind::INSTANCE);
        const Driver &first = a.place.line <= b.place.line ? a : b, &second = &first == &a ? b : a;
        add(instance ? 12014 : 10028, second.place,
            fmt::format("{} has two drivers, here {} and at {} {} ({}); drive it in one place",
                        what, text_of(second), first.place.text(), text_of(first),
                        instance ? 12015 : 10029));
    }

    void add(unsigned number, const Place& place, std::string text) {
        messages_.push_back({number, place.file, place.line, std::move(text)});
    }

    const Netlist& netlist_;
    Messages messages_;
};

// Which bits of a variable are driven.
std::vector<bool> driven_bits(const Netlist& netlist, const Variable& v) {
    std::vector<bool> driven(v.width);
    for (const Driver& d : v.drivers) {
        if (d.kind == DriverKind::INSTANCE && !d.high_z && !netlist.drives(d.of, d.port)) {
            const auto of = netlist.modules().find(d.of);
            if (of != netlist.modules().end() && of->second.is_own) continue;
        }
        if (!d.exact) return std::vector<bool>(v.width, true);
        for (unsigned bit = d.low; bit <= d.high && bit < v.width; ++bit) driven[bit] = true;
    }
    return driven;
}

class DriverWarnings {
public:
    explicit DriverWarnings(const Netlist& netlist) : netlist_{netlist} {}

    Messages run() {
        for (const auto& [key, module] : netlist_.modules()) {
            if (!module.is_own) continue;
            for (const Variable& v : module.variables) look(module, v);
            for (const Instance& i : module.instances) look(i);
            look_at_names(module);
        }
        return std::move(messages_);
    }

private:
    void look(const NetModule& module, const Variable& v) {
        if (v.is_local || v.is_parameter || v.is_loop_variable ||
            v.name.compare(0, 6, "de1sim") == 0)
            return;
        if (v.direction == "input") {
            if (module.is_top && v.reads == 0)
                add(15610, v.place, fmt::format("input {} is not used by anything", v.name));
            return;
        }
        const std::vector<bool> driven = driven_bits(netlist_, v);
        const bool is_driven = std::find(driven.begin(), driven.end(), true) != driven.end();
        const bool by_statement = std::any_of(v.drivers.begin(), v.drivers.end(), [](auto& d) {
            return d.kind == DriverKind::ASSIGN || d.kind == DriverKind::ALWAYS ||
                   d.kind == DriverKind::TASK;
        });
        if (v.direction == "inout") {
            if (module.is_top && !is_driven)
                add(13040, v.place,
                    fmt::format("inout {} is never driven; it is an input then", v.name));
        } else if (v.direction == "output") {
            if (!is_driven)
                add(10034, v.place, fmt::format("output {} has no driver, so it is 0", v.name));
            else
                each_gap(v, driven, [&](unsigned low, unsigned high) {
                    add(10034, v.place,
                        fmt::format("output {} has no driver, so it is 0", bits_of(v, low, high)));
                });
            if (module.is_top) stuck(v);
        } else if (v.reads > 0 && !is_driven && !v.has_pull) {
            add(10858, v.place,
                fmt::format("{} is used, but nothing drives it, so it is 0", v.name));
        } else if (v.reads > 0 && !v.is_array && !v.has_pull) {
            each_gap(v, driven, [&](unsigned low, unsigned high) {
                add(10030, v.place,
                    fmt::format("{} has no driver and no initial value, so it is 0",
                                bits_of(v, low, high)));
            });
        } else if (v.reads == 0 && by_statement) {
            add(10036, v.place, fmt::format("{} is assigned, but never read", v.name));
        }
    }

    void look_at_names(const NetModule& module) {
        std::map<std::string, const Variable*> names;
        for (const Variable& v : module.variables) {
            if (v.is_local || v.is_parameter || v.name.compare(0, 6, "de1sim") == 0) continue;
            const auto [first, is_new] = names.emplace(lower(v.name), &v);
            if (!is_new && first->second->name != v.name)
                add(10281, v.place,
                    fmt::format("{} and {} differ in their case alone, and are two things", v.name,
                                first->second->name));
        }
    }

    template <class Report>
    static void each_gap(const Variable& v, const std::vector<bool>& driven, Report report) {
        if (v.is_array || v.width > 4096) return;
        for (unsigned bit = 0; bit < v.width; ++bit) {
            if (driven[bit]) continue;
            const unsigned low = bit;
            while (bit + 1 < v.width && !driven[bit + 1]) ++bit;
            report(low, bit);
        }
    }

    // By assigns of constants.
    void stuck(const Variable& v) {
        for (const Driver& d : v.drivers)
            if (d.kind == DriverKind::ASSIGN && d.exact && d.value.compare(0, 5, "const") == 0 &&
                d.value.find_first_of("zZx") == std::string::npos)
                add(13410, d.place,
                    fmt::format("output {} is constant", bits_of(v, d.low, d.high)));
    }

    // The inputs of own modules that are left open; models' have their defaults.
    void look(const Instance& i) {
        const auto of = netlist_.modules().find(i.of);
        if (of == netlist_.modules().end() || !of->second.is_own) return;
        std::string open;
        for (const auto& [port, index] : of->second.ports) {
            if (of->second.variables[index].direction != "input") continue;
            const bool connected = std::any_of(
                i.connections.begin(), i.connections.end(),
                [&name = port](const Connection& c) { return c.port == name && !c.is_open; });
            if (!connected) open += (open.empty() ? "" : ", ") + port;
        }
        if (!open.empty())
            add(12241, i.place,
                fmt::format("instance {} of {}: not connected, so 0: {}", i.name, of->second.name,
                            open));
    }

    void add(unsigned number, const Place& place, std::string text) {
        messages_.push_back({number, place.file, place.line, std::move(text)});
    }

    const Netlist& netlist_;
    Messages messages_;
};

}  // namespace

Messages driver_errors(const Netlist& netlist) { return Conflicts{netlist}.run(); }
Messages driver_warnings(const Netlist& netlist) { return DriverWarnings{netlist}.run(); }

}  // namespace sim::project
