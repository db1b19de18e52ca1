#include "sim/project/qsys/assembly.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include "sim/project/module_files.h"
#include "sim/project/settings.h"
#include "sim/text/lower.h"
#include "sim/text/printable.h"

namespace sim::project::qsys {

namespace fs = std::filesystem;

namespace {

constexpr const char* HPS = "altera_hps";
constexpr unsigned LONGEST_CHAIN = 100;  // of clock bridges

// What a computer at the JTAG port alone would use.
bool is_for_jtag(const std::string& kind) {
    static const std::set<std::string> KINDS{"altera_jtag_avalon_master", "intr_capturer",
                                             "interrupt_latency_counter"};
    return KINDS.count(kind) != 0;
}

// A Nios processor, or hardware that only a Nios reaches.
bool is_nios(const std::string& kind) {
    return kind.rfind("altera_nios", 0) == 0 || kind.rfind("intel_nios", 0) == 0;
}

}  // namespace

bool End::is_processors() const { return instance->kind == HPS; }

Assembly::Assembly(const System& system, const Describe& describe) : system_{system} {
    for (const Instance& instance : system.instances) read_component_of(instance, describe);
    for (const auto& [why, names] : left_out_)
        notes_.push_back(
            fmt::format("{}: left out, {}: {}", system.file.filename().string(), why, names));
    for (const Connection& c : system.connections)
        if (!silent_.count(instance_of(c.start)) && !silent_.count(instance_of(c.end)))
            connections_.push_back(c);
    fill_in_rates(describe);
}

// Platform Designer writes AUTO_CLK_CLOCK_RATE, that of the interface clk; within a subsystem as 0.
void Assembly::fill_in_rates(const Describe& describe) {
    for (const Instance& instance : system_.instances) {
        const auto component = components_.find(instance.name);
        if (component == components_.end()) continue;
        Parameters parameters = instance.parameters;
        for (const Interface& i : component->second.interfaces) {
            const auto is_its = [&](const auto& p) {
                return lower(p.first) == lower("AUTO_" + i.name + "_CLOCK_RATE");
            };
            const auto rate = std::find_if(parameters.begin(), parameters.end(), is_its);
            if (i.type != "clock" || i.is_start || rate == parameters.end() || rate->second != "0")
                continue;
            const std::string hertz = hertz_of(end(root_of({&instance, &component->second, &i})));
            if (!hertz.empty()) rate->second = hertz;
        }
        if (parameters != instance.parameters) component->second = *describe(instance, parameters);
    }
}

// Of a clock that comes from outside, from a PLL, or from the processor; empty: it is not known.
std::string Assembly::hertz_of(const End& root) const {
    const auto given = root.instance->parameters.find("clockFrequency");
    if (root.instance->kind == "clock_source" && given != root.instance->parameters.end())
        return given->second;
    const Port* port = root.interface->port("clk");
    if (!port) return {};
    const auto& all = root.component->parameters;
    if (root.is_processors()) {
        const auto period = all.find("USER" + port->name.substr(8, 1) + "_PERIOD_FS");
        return period == all.end() ? "" : fmt::format("{:.0f}", 1e15 / std::stod(period->second));
    }
    const auto found =
        all.find("output_clock_frequency" + port->name.substr(port->name.rfind('_') + 1));
    if (found == all.end()) return {};
    const double mhz = std::atof(found->second.c_str() + (found->second[0] == '"'));
    return mhz > 0 ? fmt::format("{:.0f}", mhz * 1e6) : "";
}

void Assembly::fail(const std::string& what) const {
    throw ProjectError{printable(system_.file.filename().string() + ": " + what)};
}

void Assembly::read_component_of(const Instance& instance, const Describe& describe) {
    if (is_for_jtag(instance.kind)) return leave_out(instance, "for a computer at the JTAG port");
    const auto component = describe(instance, instance.parameters);
    if (!component && is_nios(instance.kind)) {
        if (has_processor()) return leave_out(instance, "since a Nios cannot be simulated");
        fail(
            fmt::format("{} is a Nios ({}), which cannot be simulated, and the system has no ARM "
                        "(altera_hps)",
                        instance.name, instance.kind));
    }
    if (!component)
        throw UnknownKind{printable(
            fmt::format("{0}: {1} is of the kind {2}, which is not known here, and the project has "
                        "no {2}_hw.tcl, {2}.qsys or module {2}",
                        system_.file.filename().string(), instance.name, instance.kind))};
    for (const ComponentFile& source : component->files) {
        const fs::path path = (component->file.parent_path() / source.path).lexically_normal();
        if (language_of(path) &&
            std::find(sources_.begin(), sources_.end(), path) == sources_.end())
            sources_.push_back(path);
    }
    components_.emplace(instance.name, *component);
}

void Assembly::leave_out(const Instance& instance, const std::string& why) {
    std::string& names = left_out_[why];
    names += fmt::format("{}{} ({})", names.empty() ? "" : ", ", instance.name, instance.kind);
    silent_.insert(instance.name);
}

bool Assembly::has_processor() const {
    return std::any_of(system_.instances.begin(), system_.instances.end(),
                       [](const Instance& i) { return i.kind == HPS; });
}

std::optional<End> Assembly::find_end(const std::string& name) const {
    const std::size_t dot = name.find('.');
    const auto component = components_.find(name.substr(0, dot));
    if (component == components_.end() || dot == std::string::npos) return {};
    const Interface* interface = component->second.interface(name.substr(dot + 1));
    if (!interface) return {};
    for (const Instance& instance : system_.instances)
        if (instance.name == component->first) return End{&instance, &component->second, interface};
    return {};
}

End Assembly::end(const std::string& name) const {
    if (const auto found = find_end(name)) return *found;
    fail(fmt::format("a connection names {}, but {} has no such interface", name,
                     instance_of(name)));
}

void Assembly::for_each(const std::function<void(const End&)>& visit) const {
    for (const Instance& instance : system_.instances) {
        const auto component = components_.find(instance.name);
        if (component == components_.end()) continue;
        for (const Interface& i : component->second.interfaces)
            visit({&instance, &component->second, &i});
    }
}

void Assembly::for_each(const std::string& type, bool is_start,
                        const std::function<void(const End&)>& visit) const {
    for_each([&](const End& e) {
        if (e.interface->type == type && e.interface->is_start == is_start) visit(e);
    });
}

const Export* Assembly::exported(const End& e) const {
    for (const Export& x : system_.exports)
        if (x.internal == e.name()) return &x;
    return nullptr;
}

const Connection* Assembly::clock_source(const End& sink) const {
    for (const Connection& c : connections_)
        if (c.kind == Connection::Kind::CLOCK && c.end == sink.name()) return &c;
    return nullptr;
}

std::string Assembly::root_of(const End& sink, unsigned depth) const {
    const Connection* c = clock_source(sink);
    if (!c || depth > LONGEST_CHAIN) return sink.name();
    const End source = end(c->start);
    const Interface* through =
        source.component->interface(source.interface->property("associatedDirectClock"));
    if (!through) return source.name();
    return root_of({source.instance, source.component, through}, depth + 1);
}

Assembly::Clock Assembly::clock_of(const End& e) const {
    const std::string name = e.interface->property("associatedClock");
    const Interface* clock = e.component->interface(name);
    if (!clock || !clock->port("clk"))
        fail(fmt::format("{} has no clock: its associatedClock is \"{}\"", e.name(), name));
    const End sink{e.instance, e.component, clock};
    return {sink.wire("clk"), root_of(sink)};
}

std::string Assembly::active_high(const End& e) {
    if (const Port* port = e.interface->port("reset")) return e.wire(*port);
    if (const Port* port = e.interface->port("reset_n")) return "!" + e.wire(*port);
    return "1'b0";
}

std::string Assembly::reset_of(const End& e) const {
    const Interface* i = e.component->interface(e.interface->property("associatedReset"));
    return i && !i->is_start ? active_high({e.instance, e.component, i}) : "1'b0";
}

}  // namespace sim::project::qsys
