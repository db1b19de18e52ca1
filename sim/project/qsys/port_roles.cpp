#include "sim/project/qsys/port_roles.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "sim/project/settings.h"
#include "sim/text/lower.h"
#include "sim/text/printable.h"

namespace sim::project::qsys {

namespace {

// What a port's name ends with, without "_"; `by_sink` drives it at a slave, a sink, a receiver.
struct Role {
    const char *type, *ending, *role;
    bool by_sink;
};
constexpr Role ROLES[] = {{"clock", "clk", "clk", false},
                          {"clock", "clock", "clk", false},
                          {"reset", "reset", "reset", false},
                          {"reset", "rst", "reset", false},
                          {"reset", "resetn", "reset_n", false},
                          {"reset", "rstn", "reset_n", false},
                          {"interrupt", "irq", "irq", true},
                          {"interrupt", "irqn", "irq_n", true},
                          {"interrupt", "interrupt", "irq", true},
                          {"avalon", "address", "address", false},
                          {"avalon", "addr", "address", false},
                          {"avalon", "byteenable", "byteenable", false},
                          {"avalon", "byteenablen", "byteenable_n", false},
                          {"avalon", "chipselect", "chipselect", false},
                          {"avalon", "chipselectn", "chipselect_n", false},
                          {"avalon", "read", "read", false},
                          {"avalon", "readn", "read_n", false},
                          {"avalon", "write", "write", false},
                          {"avalon", "writen", "write_n", false},
                          {"avalon", "writedata", "writedata", false},
                          {"avalon", "burstcount", "burstcount", false},
                          {"avalon", "readdata", "readdata", true},
                          {"avalon", "readdatavalid", "readdatavalid", true},
                          {"avalon", "readdatavalidn", "readdatavalid_n", true},
                          {"avalon", "waitrequest", "waitrequest", true},
                          {"avalon", "waitrequestn", "waitrequest_n", true},
                          {"avalon_streaming", "data", "data", false},
                          {"avalon_streaming", "valid", "valid", false},
                          {"avalon_streaming", "ready", "ready", true},
                          {"avalon_streaming", "startofpacket", "startofpacket", false},
                          {"avalon_streaming", "endofpacket", "endofpacket", false},
                          {"avalon_streaming", "empty", "empty", false}};

// In lower case, without "_" and the ending of ports by direction.
std::string plain(std::string name) {
    name = lower(std::move(name));
    for (const char* ending : {"_i", "_o"})
        if (name.size() > 2 && name.compare(name.size() - 2, 2, ending) == 0)
            name.resize(name.size() - 2);
    name.erase(std::remove(name.begin(), name.end(), '_'), name.end());
    return name;
}

bool ends_with(const std::string& text, std::string_view ending) {
    return text.size() >= ending.size() &&
           text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

struct Used {  // an interface that the system uses
    std::string name, type;
    bool is_start, is_exported;
    std::map<std::string, std::string> ports;  // by role; of a conduit by their own names
};

class Describer {
public:
    Describer(const ModuleText& module, const System& system, const Instance& instance)
        : module_{module}, system_{system}, instance_{instance} {}

    std::string run() {
        find_interfaces();
        std::vector<std::string> left;
        for (const std::string& port : module_.ports)
            if (!give(port)) left.push_back(port);
        give_to_conduit(left);
        for (const Used& i : used_)
            if (i.type == "avalon" && !i.ports.count("readdata") && !i.ports.count("writedata"))
                fail(fmt::format("no port has the name of data of {}", i.name));
        return text();
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        std::string ports;
        for (const std::string& port : module_.ports) ports += (ports.empty() ? "" : ", ") + port;
        throw ProjectError{printable(fmt::format(
            "{}: {} is of the kind {}, which has no _hw.tcl and no .sopcinfo, and by its Verilog's "
            "ports ({}): {}",
            system_.file.filename().string(), instance_.name, instance_.kind, ports, what))};
    }

    // ---- The interfaces ----

    void use(const std::string& end, const std::string& type, bool is_start, bool is_exported) {
        const std::string prefix = instance_.name + ".";
        if (end.compare(0, prefix.size(), prefix) != 0) return;
        const std::string name = end.substr(prefix.size());
        for (const Used& i : used_)
            if (i.name == name) return;
        used_.push_back({name, type, is_start, is_exported, {}});
    }

    void find_interfaces() {
        using Kind = Connection::Kind;
        static const std::map<Kind, const char*> TYPES{
            {Kind::AVALON, "avalon"},   {Kind::CLOCK, "clock"},
            {Kind::RESET, "reset"},     {Kind::INTERRUPT, "interrupt"},
            {Kind::CONDUIT, "conduit"}, {Kind::STREAMING, "avalon_streaming"}};
        for (const Connection& c : system_.connections)
            if (const auto type = TYPES.find(c.kind); type != TYPES.end()) {
                use(c.start, type->second, true, false);
                use(c.end, type->second, false, false);
            }
        for (const Export& x : system_.exports) use(x.internal, x.type, x.is_start, true);
    }

    // ---- The ports ----

    // To the interface that has a signal of its name: the one that the name has in it, else the
    // first that has not got this signal yet.
    bool give(const std::string& port) {
        const std::string name = plain(port);
        const bool is_output = module_.outputs.count(port) > 0;
        Used* best = nullptr;
        const Role* best_role = nullptr;
        std::size_t most = 0;
        for (Used& i : used_)
            for (const Role& r : ROLES) {
                if (i.type != r.type || !ends_with(name, r.ending) || i.ports.count(r.role) ||
                    is_output != (r.by_sink != i.is_start))
                    continue;
                const bool is_named = name.find(plain(i.name)) != std::string::npos;
                const std::size_t score = 2 * std::string_view{r.ending}.size() + is_named;
                if (score <= most) continue;
                most = score;
                best = &i;
                best_role = &r;
            }
        if (best) best->ports[best_role->role] = port;
        return best != nullptr;
    }

    void give_to_conduit(const std::vector<std::string>& left) {
        std::vector<Used*> conduits;
        for (Used& i : used_)
            if (i.type == "conduit") conduits.push_back(&i);
        for (const std::string& port : left) {
            Used* taken = conduits.size() == 1 ? conduits[0] : nullptr;
            for (Used* i : conduits)
                if (plain(port).find(plain(i->name)) != std::string::npos) taken = i;
            if (!taken && !conduits.empty())
                fail(fmt::format("{} may belong to any of its conduits", port));
            if (taken) taken->ports[port] = port;
        }
    }

    // ---- The text ----

    const Used* first(const char* type) const {
        for (const Used& i : used_)
            if (i.type == type && !i.is_start) return &i;
        return nullptr;
    }

    // "7 : 0" is 8.
    std::string width_of(const std::string& port) const {
        const auto range = module_.ranges.find(port);
        if (range == module_.ranges.end()) return "1";
        const std::size_t colon = range->second.find(':');
        return colon == std::string::npos
                   ? "1"
                   : fmt::format("({})-({})+1", range->second.substr(0, colon),
                                 range->second.substr(colon + 1));
    }

    std::string text() const {
        std::string text = fmt::format(
            "set_module_property NAME {{{}}}\nset_module_property VERSION {{{}}}\n"
            "add_fileset synth QUARTUS_SYNTH {{}}\nset_fileset_property synth TOP_LEVEL {{{}}}\n",
            instance_.kind, instance_.version, module_.name);
        for (const std::string& p : module_.parameters) {
            const auto given = module_.defaults.find(p);
            text += fmt::format(
                "add_parameter {0} INTEGER {{{1}}}\n"
                "set_parameter_property {0} HDL_PARAMETER true\n",
                p, given == module_.defaults.end() ? "0" : given->second);
        }
        const Used *clock = first("clock"), *reset = first("reset");
        for (const Used& i : used_) {
            text += fmt::format("add_interface {} {} {}\n", i.name, i.type,
                                i.is_start ? "start" : "end");
            if (clock && i.type != "clock")
                text += fmt::format("set_interface_property {} associatedClock {}\n", i.name,
                                    clock->name);
            if (reset && i.type != "clock" && i.type != "reset")
                text += fmt::format("set_interface_property {} associatedReset {}\n", i.name,
                                    reset->name);
            for (const auto& [role, port] : i.ports)
                text += fmt::format("add_interface_port {} {} {} {} {{{}}}\n", i.name, port,
                                    i.type == "conduit" ? "export" : role,
                                    module_.outputs.count(port)  ? "Output"
                                    : module_.inouts.count(port) ? "Bidir"
                                                                 : "Input",
                                    width_of(port));
        }
        return text;
    }

    const ModuleText& module_;
    const System& system_;
    const Instance& instance_;
    std::vector<Used> used_;
};

}  // namespace

std::string description_by_ports(const ModuleText& module, const System& system,
                                 const Instance& instance) {
    return Describer{module, system, instance}.run();
}

}  // namespace sim::project::qsys
