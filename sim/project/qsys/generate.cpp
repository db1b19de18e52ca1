#include "sim/project/qsys/generate.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "sim/project/qsys/streams.h"
#include "sim/text/lower.h"

namespace sim::project::qsys {

namespace {

using Direction = Port::Direction;

class Generator {
public:
    Generator(const System& system, const Describe& describe)
        : system_{system}, assembly_{system, describe} {}

    Generated run() {
        clocks();
        resets();
        interrupts();
        conduits();
        streams();
        Interconnect interconnect = write_interconnect(assembly_, text_);
        std::vector<Device> devices = devices_of(assembly_, interconnect.map);
        const auto pixels = pixel_buffer_of(assembly_, interconnect.map);
        instances();
        Generated out{"",
                      std::move(instance_modules_),
                      assembly_.sources(),
                      std::move(interconnect.map),
                      std::move(interconnect.bridges),
                      assembly_.notes(),
                      assembly_.has_processor(),
                      std::move(devices),
                      system_.name,
                      pixels};
        out.notes.insert(out.notes.end(), interconnect.notes.begin(), interconnect.notes.end());
        out.text = fmt::format(
            "// {0}.v - made by de1sim of {0}.qsys\n{1}\n`default_nettype none\n\n"
            "module {0} (\n{2});\n{3}\n{4}\nendmodule\n\n`default_nettype wire\n",
            system_.name, map_text(out.map), ports_text(), wires_text(), text_.body);
        return out;
    }

private:
    // ---- Clocks, resets, interrupts, conduits, streams ----

    void clocks() {
        text_.section("Clocks");
        assembly_.for_each("clock", false, [&](const End& sink) {
            const Port* port = sink.interface->port("clk");
            const Connection* c = assembly_.clock_source(sink);
            if (!port || assembly_.exported(sink)) return;
            if (!c)
                return text_.line(
                    fmt::format("assign {} = 1'b0;  // not connected", sink.wire(*port)));
            const End source = assembly_.end(c->start);
            text_.line(fmt::format("assign {} = {};", sink.wire(*port), source.wire("clk")));
        });
    }

    void resets() {
        text_.section("Resets");
        assembly_.for_each("reset", false, [&](const End& sink) {
            if (assembly_.exported(sink)) return;
            std::string sources;
            for (const Connection& c : assembly_.connections())
                if (c.kind == Connection::Kind::RESET && c.end == sink.name())
                    sources += (sources.empty() ? "" : " || ") +
                               Assembly::active_high(assembly_.end(c.start));
            const Port* high = sink.interface->port("reset");
            const Port* low = sink.interface->port("reset_n");
            if (const Port* request = sink.interface->port("reset_req"))
                text_.line(fmt::format("assign {} = 1'b0;", sink.wire(*request)));
            if (!high && !low) return;
            const std::string wire = sink.wire(high ? *high : *low), own = wire + "_active";
            const std::string clock = sink.interface->property("associatedClock");
            const Interface* i = sink.component->interface(clock);
            text_.wire(own, 1);
            if (sources.empty()) {
                text_.line(fmt::format("assign {} = 1'b0;  // not connected", own));
            } else if (i && i->port("clk") &&
                       lower(sink.interface->property("synchronousEdges", "deassert")) != "none") {
                text_.line(fmt::format("de1sim_reset {}_sync (.clk_i({}), .rst_i({}), .rst_o({}));",
                                       wire, End{sink.instance, sink.component, i}.wire("clk"),
                                       sources, own));
            } else {
                text_.line(fmt::format("assign {} = {};", own, sources));
            }
            text_.line(fmt::format("assign {} = {}{};", wire, high ? "" : "!", own));
        });
    }

    void interrupts() {
        text_.section("Interrupts");
        assembly_.for_each("interrupt", true, [&](const End& receiver) {
            const Port* port = receiver.interface->port("irq");
            if (!port || assembly_.exported(receiver)) return;
            std::map<unsigned, End> senders;
            for (const Connection& c : assembly_.connections())
                if (c.kind == Connection::Kind::INTERRUPT && c.start == receiver.name()) {
                    const auto [other, is_new] = senders.emplace(c.interrupt, assembly_.end(c.end));
                    if (!is_new)
                        assembly_.fail(fmt::format("interrupt {} of {} is that of {} and of {}",
                                                   c.interrupt, receiver.name(),
                                                   other->second.name(), c.end));
                    if (c.interrupt >= port->width)
                        assembly_.fail(fmt::format("{} has interrupt {} of {}, which has {}", c.end,
                                                   c.interrupt, receiver.name(), port->width));
                }
            for (unsigned n = 0; n < port->width; ++n) {
                const auto sender = senders.find(n);
                if (sender == senders.end()) continue;
                text_.line(fmt::format("assign {}{} = {};", receiver.wire(*port),
                                       port->width > 1 ? fmt::format("[{}]", n) : "",
                                       sender->second.wire("irq")));
            }
            for (unsigned n = 0; n < port->width; ++n)
                if (!senders.count(n))
                    text_.line(fmt::format("assign {}{} = 1'b0;", receiver.wire(*port),
                                           port->width > 1 ? fmt::format("[{}]", n) : ""));
        });
    }

    void streams() {
        text_.section("Streams");
        for (const Connection& c : assembly_.connections())
            if (c.kind == Connection::Kind::STREAMING)
                write_stream(assembly_, text_, assembly_.end(c.start), assembly_.end(c.end));
    }

    // Signals of one role at both sides.
    void conduits() {
        text_.section("Conduits");
        for (const Connection& c : assembly_.connections()) {
            if (c.kind != Connection::Kind::CONDUIT) continue;
            const End a = assembly_.end(c.start), b = assembly_.end(c.end);
            for (const Port& port : a.interface->ports) {
                const Port* other = b.interface->port(port.role);
                if (!other || port.width == 0) continue;
                const bool from_a = port.direction == Direction::OUTPUT;
                text_.line(fmt::format("assign {} = {};", from_a ? b.wire(*other) : a.wire(port),
                                       from_a ? a.wire(port) : b.wire(*other)));
            }
        }
    }

    // ---- Instances ----

    void instances() {
        for (const Instance& instance : system_.instances) {
            std::string ports, module, parameters, declared, passed;
            bool is_processor = false;
            assembly_.for_each([&](const End& e) {
                if (e.instance != &instance) return;
                is_processor = e.is_processors();
                module = e.component->module;
                if (parameters.empty())
                    for (const auto& [name, value] : e.component->parameters)
                        parameters +=
                            fmt::format("{}.{}({})", parameters.empty() ? "" : ", ", name, value);
                for (const Port& port : e.interface->ports) {
                    if (port.width == 0) continue;
                    const char* comma = ports.empty() ? "" : ",";
                    ports += fmt::format("{}\n        .{}({})", comma, port.name, wire_of(e, port));
                    passed += fmt::format("{} .{}({})", comma, port.name, port.name);
                    declared += comma + declaration(port, port.name);
                }
            });
            if (ports.empty()) continue;
            const std::string set = parameters.empty() ? "" : " #(" + parameters + ")";
            if (!is_processor)
                instance_modules_[system_.name + "_" + instance.name] =
                    fmt::format("module {}_{} ({});\n    {}{} {} ({});\nendmodule\n", system_.name,
                                instance.name, declared, module, set, instance.name, passed);
            text_.section(fmt::format("{}: {}", instance.name, instance.kind));
            if (is_processor)
                processor(instance.name, parameters);
            else
                text_.line(fmt::format("{}{} {} ({}\n    );", module, set, instance.name, ports));
        }
    }

    // A port to the processor's memory, for a master at the top.
    void exported_slave(const Export& x, const End& e) {
        const Interface& i = *e.interface;
        const unsigned number = i.number("commandPort", 0);
        const std::string clock =
            End{e.instance, e.component, e.component->interface(i.property("associatedClock"))}
                .wire("clk");
        const auto wire = [&](const char* role) {
            const Port* port = i.port(role);
            return port ? port_name(x, e, *port) : std::string{"1'b0"};
        };
        const Port* data = i.port(is_axi(i) ? "rdata" : "readdata");
        if (!data) data = i.port("writedata");
        const std::string name = fmt::format("{}_{}", e.instance->name, i.name);
        if (is_axi(i)) {
            std::string ports;
            for (const Port& port : i.ports)
                ports += fmt::format(",\n        .{}({})", port.role, port_name(x, e, port));
            unsigned size = 0;
            while (32u << size < data->width) ++size;
            return text_.line(fmt::format(
                "cyclonev_hps_interface_fpga2hps #(.COMMAND_PORT({}), .WIDTH({})) {} (\n"
                "        .clk({}), .port_size_config(2'd{}){}\n    );",
                number, data->width, name, clock, size, ports));
        }
        text_.line(fmt::format(
            "de1sim_hps_avalon_port #(.PORT({}), .WIDTH({})) {} (\n        .clk_i({}),\n"
            "        .address_i({}), .burstcount_i({}), .read_i({}), .write_i({}),\n"
            "        .writedata_i({}), .byteenable_i({}),\n"
            "        .waitrequest_o({}), .readdata_o({}), .readdatavalid_o({})\n    );",
            number, data->width, name, clock, wire("address"), wire("burstcount"), wire("read"),
            wire("write"), wire("writedata"), wire("byteenable"), wire("waitrequest"),
            i.port("readdata") ? wire("readdata") : "",
            i.port("readdata") ? wire("readdatavalid") : ""));
    }

    // Of the processor: its primitives but those of its bridges, which are agents of the
    // interconnect, and its slaves that are exported; what its own pins do is not simulated.
    void processor(const std::string& name, const std::string& parameters) {
        const auto wire = [&](const char* interface, const char* role, const char* otherwise) {
            const auto e = assembly_.find_end(name + "." + interface);
            return e ? wire_of(*e, *e->interface->port(role)) : std::string{otherwise};
        };
        const auto request = [&](const char* which) {
            return wire(fmt::format("f2h_{}_reset_req", which).c_str(), "reset_n", "1'b1");
        };
        text_.line(fmt::format(
            "cyclonev_hps_interface_clocks_resets #({}) {}_clocks_resets (\n"
            "        .h2f_rst_n({}), .h2f_cold_rst_n({}), .f2h_cold_rst_req_n({}),\n"
            "        .f2h_warm_rst_req_n({}), .f2h_dbg_rst_req_n({}),\n"
            "        .h2f_user0_clk({}), .h2f_user1_clk({}), .h2f_user2_clk({})\n    );",
            parameters, name, wire("h2f_reset", "reset_n", ""),
            wire("h2f_cold_reset", "reset_n", ""), request("cold"), request("warm"),
            request("debug"), wire("h2f_user0_clock", "clk", ""),
            wire("h2f_user1_clock", "clk", ""), wire("h2f_user2_clock", "clk", "")));
        text_.line(fmt::format(
            "cyclonev_hps_interface_interrupts {}_interrupts (.irq({{{},\n        {}}}));", name,
            wire("f2h_irq1", "irq", "32'd0"), wire("f2h_irq0", "irq", "32'd0")));
        if (assembly_.find_end(name + ".h2f_gp"))
            text_.line(
                fmt::format("cyclonev_hps_interface_mpu_general_purpose {}_gp (\n"
                            "        .gp_in({}), .gp_out({})\n    );",
                            name, wire("h2f_gp", "gp_in", ""), wire("h2f_gp", "gp_out", "")));
        for (const Export& x : system_.exports) {
            const auto e = assembly_.find_end(x.internal);
            if (!e || !e->is_processors()) continue;
            if (is_axi(*e->interface) || e->interface->type == "avalon") exported_slave(x, *e);
        }
        dma_requests(name);
        assembly_.for_each([&](const End& e) {
            if (!e.is_processors() || e.instance->name != name) return;
            const std::string& what = e.interface->name;
            if (e.interface->type != "conduit" || what == "h2f_gp" || is_unused_pins(e) ||
                what.substr(0, 11) == "f2h_dma_req" || processor_peripheral(e))
                return;
            for (const Port& port : e.interface->ports)
                if (port.direction == Direction::OUTPUT) {
                    const bool rests_high =
                        what.substr(0, 3) == "can" || what == "h2f_warm_reset_handshake";
                    text_.line(fmt::format("assign {} = {{{}{{1'b{}}}}};", wire_of(e, port),
                                           port.width, rests_high ? 1 : 0));
                }
        });
        assembly_.for_each([&](const End& e) {
            const std::string& what = e.interface->name;
            const bool rests = what.substr(0, 4) == "emac" || what == "h2f_tpiu_clock" ||
                               what == "h2f_debug_apb_reset";
            if (!e.is_processors() || e.instance->name != name || !rests || !e.interface->is_start)
                return;
            if (const Port* clock = e.interface->port("clk"))
                text_.line(fmt::format("assign {} = 1'b0;", wire_of(e, *clock)));
            if (const Port* reset = e.interface->port("reset_n"))
                text_.line(fmt::format("assign {} = 1'b1;", wire_of(e, *reset)));
        });
    }

    // Pins of the processor's that the top has not.
    bool is_unused_pins(const End& e) const {
        return e.is_processors() && !assembly_.exported(e) &&
               (e.interface->name == "memory" || e.interface->name == "hps_io");
    }

    void dma_requests(const std::string& name) {
        std::string ports;
        for (unsigned n = 0; n < 8; ++n) {
            const auto e = assembly_.find_end(fmt::format("{}.f2h_dma_req{}", name, n));
            if (!e) continue;
            for (const auto& [role, port] :
                 {std::pair{"dma_req", "req"}, std::pair{"dma_single", "single"},
                  std::pair{"dma_ack", "xx_ack"}})
                ports += fmt::format("{}\n        .channel{}_{}({})", ports.empty() ? "" : ",", n,
                                     port, wire_of(*e, *e->interface->port(role)));
        }
        if (!ports.empty())
            text_.line(fmt::format("cyclonev_hps_interface_dma {}_dma ({}\n    );", name, ports));
    }

    void loan_io(const End& e) {
        const auto wire = [&](const char* role) { return wire_of(e, *e.interface->port(role)); };
        const std::string name = e.instance->name, rest = name + "_inputs_alone";
        text_.wire(rest, 4);
        text_.line(fmt::format(
            "cyclonev_hps_interface_loan_io #(.LOANED({})) {}_loan_io (\n"
            "        .loanio_in({{{}, {}}}), .loanio_out({{4'd0, {}}}), .loanio_oe({{4'd0, {}}})\n"
            "    );",
            e.interface->property("loaned"), name, rest, wire("in"), wire("out"), wire("oe")));
    }

    // One whose signals are in the FPGA, by its primitive; false: none is made of this conduit.
    bool processor_peripheral(const End& e) {
        struct Kind {
            const char *name, *primitive;
            std::vector<std::pair<const char*, const char*>> clocks;  // interface, primitive's port
        };
        static const std::vector<Kind> KINDS{
            {"uart", "peripheral_uart", {}},
            {"i2c", "peripheral_i2c", {{"_scl_in", "scl"}, {"_clk", "out_clk"}}},
            {"spim", "peripheral_spi_master", {{"_sclk_out", "sclk_out"}}},
            {"spis", "peripheral_spi_slave", {{"_sclk_in", "sclk_in"}}}};
        const std::string &interface = e.interface->name, name = e.instance->name;
        if (interface == "h2f_loan_io") {
            loan_io(e);
            return true;
        }
        std::string ports;
        for (const Port& port : e.interface->ports)
            ports += fmt::format("{}\n        .{}({})", ports.empty() ? "" : ",", port.role,
                                 wire_of(e, port));
        for (const Kind& kind : KINDS) {
            if (interface.substr(0, interface.size() - 1) != kind.name) continue;
            for (const auto& [clock, port] : kind.clocks)
                if (const auto end = assembly_.find_end(name + "." + interface + clock))
                    ports += fmt::format(",\n        .{}({})", port,
                                         wire_of(*end, *end->interface->port("clk")));
            text_.line(fmt::format("cyclonev_hps_interface_{} #(.NUMBER({})) {}_{} ({}\n    );",
                                   kind.primitive, interface.back(), name, interface, ports));
            return true;
        }
        return false;
    }

    // The wire at a port of an instance; an exported interface has the system's port.
    std::string wire_of(const End& e, const Port& port) const {
        const Export* x = assembly_.exported(e);
        return x ? port_name(*x, e, port) : e.wire(port);
    }

    // ---- The module's head ----

    // EXPORT_ROLE; several signals of the role "export" have the names of their ports, without
    // what they have in common up to a "_".
    static std::string port_name(const Export& x, const End& e, const Port& port) {
        const auto has_role = [](const Port& p) { return p.role == "export" && p.width > 0; };
        const auto& ports = e.interface->ports;
        if (!has_role(port) || std::count_if(ports.begin(), ports.end(), has_role) < 2)
            return x.name + "_" + port.role;
        std::string common = port.name;
        for (const Port& p : ports)
            if (has_role(p)) {
                const auto [a, b] =
                    std::mismatch(common.begin(), common.end(), p.name.begin(), p.name.end());
                common.erase(a, common.end());
            }
        const std::size_t underscore = common.rfind('_');
        const std::string rest =
            underscore == std::string::npos ? port.name : port.name.substr(underscore + 1);
        return x.name + "_" + rest;
    }

    static std::string declaration(const Port& port, const std::string& name) {
        const char* direction = port.direction == Direction::INPUT    ? "input  wire "
                                : port.direction == Direction::OUTPUT ? "output wire "
                                                                      : "inout  wire ";
        return direction + VerilogText::range(port.width, port.is_vector) + name;
    }

    std::string ports_text() const {
        std::string text;
        for (const Export& x : system_.exports) {
            const auto e = assembly_.find_end(x.internal);
            if (!e) continue;
            for (const Port& port : e->interface->ports) {
                if (port.width == 0) continue;
                text +=
                    (text.empty() ? "    " : ",\n    ") + declaration(port, port_name(x, *e, port));
            }
        }
        return text.empty() ? "" : text + "\n";
    }

    // The instances' own wires, and those of the interconnect.
    std::string wires_text() const {
        std::string text;
        assembly_.for_each([&](const End& e) {
            const std::string& type = e.interface->type;
            if (is_unused_pins(e)) return;
            const Export* x = assembly_.exported(e);
            // Inside of the system these have both names.
            const bool both = type == "clock" || type == "reset" || type == "interrupt";
            if (x && !both) return;
            for (const Port& port : e.interface->ports) {
                const std::string outside = x ? port_name(*x, e, port) : "";
                if (port.width > 0)
                    text += fmt::format("    wire {}{}{};\n",
                                        VerilogText::range(port.width, port.is_vector),
                                        e.wire(port), x ? " = " + outside : "");
            }
        });
        return text + text_.wires;
    }

    static std::string map_text(const std::vector<Place>& map) {
        std::string text, master;
        for (const Place& place : map) {
            if (place.master != master) text += fmt::format("//\n// {}\n", master = place.master);
            text += fmt::format("//   0x{:08x} - 0x{:08x}  {}{}\n", place.base,
                                place.base + place.span - 1, place.slave,
                                place.reads && place.writes ? ""
                                : place.reads               ? ", reads alone"
                                                            : ", writes alone");
        }
        return text;
    }

    const System& system_;
    const Assembly assembly_;
    VerilogText text_;
    std::map<std::string, std::string> instance_modules_;
};

}  // namespace

Generated generate(const System& system, const Describe& describe) {
    return Generator{system, describe}.run();
}

}  // namespace sim::project::qsys
