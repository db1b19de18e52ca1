#include "sim/project/qsys/interconnect.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "sim/hps/bridge_windows.h"
#include "sim/project/qsys/slave_agent.h"
#include "sim/text/lower.h"

namespace sim::project::qsys {

namespace {

class Writer {
public:
    Writer(const Assembly& assembly, VerilogText& text)
        : assembly_{assembly}, text_{text}, map_{assembly} {}

    Interconnect run() {
        out_.map = map_.places();
        out_.notes = map_.notes();
        interconnect();
        return std::move(out_);
    }

private:
    const std::vector<Slave>& slaves() const { return map_.slaves(); }

    // ---- The pieces ----

    Bus bus(const std::string& name, unsigned width, const std::string& clock,
            const std::string& reset) {
        for (const char* bit : {"_valid", "_ready", "_write", "_rvalid"}) text_.wire(name + bit, 1);
        text_.wire(name + "_address", 32);
        text_.wire(name + "_count", 16);
        text_.wire(name + "_wdata", width);
        text_.wire(name + "_rdata", width);
        text_.wire(name + "_be", width / 8, width > 8);
        return {name, width, clock, reset};
    }
    // The connections of a bus to a module's ports: as the one who asks, or who is asked.
    static std::string asks(const Bus& b) {
        return fmt::format(
            ".valid_o({0}_valid), .ready_i({0}_ready), .write_o({0}_write),\n"
            "        .count_o({0}_count), .address_o({0}_address), .wdata_o({0}_wdata), "
            ".be_o({0}_be),\n"
            "        .rvalid_i({0}_rvalid), .rdata_i({0}_rdata)",
            b.name);
    }
    void connect_command(const Bus& from, const Bus& to) {
        for (const char* wire : {"_write", "_count", "_address", "_wdata", "_be"})
            text_.line(fmt::format("assign {}{} = {}{};", to.name, wire, from.name, wire));
    }

    // An interface's name in the interconnect: its instance's, where that has no other.
    static std::string short_name(const End& e) {
        if (e.is_processors()) return e.interface->name.substr(0, e.interface->name.find("_axi"));
        const auto& all = e.component->interfaces;
        const auto same = std::count_if(all.begin(), all.end(), [&](const Interface& i) {
            return i.type == e.interface->type && i.is_start == e.interface->is_start;
        });
        return e.instance->name + (same > 1 ? "_" + e.interface->name : "");
    }

    void interconnect() {
        std::vector<std::vector<std::pair<Bus, unsigned>>> asked(slaves().size());
        for (std::size_t m = 0; m < map_.masters().size(); ++m) {
            const std::vector<Link> links = map_.links_of(m);
            text_.section("From " + map_.masters()[m].end.name());
            const Bus own = agent_of(map_.masters()[m]);
            std::vector<Bus> ways;
            for (const Link& link : links)
                ways.push_back(bus(fmt::format("{}_to_{}", short_name(map_.masters()[m].end),
                                               short_name(slaves()[link.slave].end)),
                                   own.width, own.clock, own.reset));
            decode(own, links, ways);
            for (std::size_t n = 0; n < links.size(); ++n) {
                const Slave& s = slaves()[links[n].slave];
                Bus way = ways[n];
                if (map_.masters()[m].clock != s.clock) way = crossed(way, s);
                if (way.width != s.width) way = fitted(way, s);
                asked[links[n].slave].emplace_back(way, links[n].shares);
            }
        }
        for (std::size_t n = 0; n < slaves().size(); ++n) {
            text_.section("To " + slaves()[n].end.name());
            write_slave_agent(assembly_, text_, slaves()[n], arbitrated(slaves()[n], asked[n]),
                              short_name(slaves()[n].end) + "_agent", out_.notes);
        }
    }

    Bus agent_of(const Master& m) {
        const Assembly::Clock clock = assembly_.clock_of(m.end);
        const Bus own = bus("from_" + short_name(m.end), m.width, clock.wire,
                            m.is_bridge ? "1'b0" : assembly_.reset_of(m.end));
        if (m.is_bridge) {
            text_.line(fmt::format(
                "de1sim_hps_bridge #(.FULL({}), .WIDTH({})) {}_agent (\n"
                "        .clk_i({}),\n        {}\n    );",
                window_of(m) == H2F_BASE ? 1 : 0, m.width, own.name, own.clock, asks(own)));
            return own;
        }
        const Interface& i = *m.end.interface;
        const auto from = [&](const char* role, const std::string& otherwise) {
            if (const Port* port = i.port(role)) return m.end.wire(*port);
            if (const Port* port = i.port(std::string{role} + "_n")) return "~" + m.end.wire(*port);
            return otherwise;
        };
        const auto to = [&](const char* role) {
            const Port* port = i.port(role);
            return port ? m.end.wire(*port) : std::string{};
        };
        if (is_axi(i)) {
            axi_agent(m, own, from, to);
            return own;
        }
        text_.line(fmt::format(
            "de1sim_avalon_master #(.WIDTH({}), .READDATAVALID({}), .WRAP({})) {}_agent (\n"
            "        .clk_i({}), .rst_i({}),\n        .address_i({}), .read_i({}), .write_i({}),\n"
            "        .byteenable_i({}), .writedata_i({}), .burstcount_i({}),\n"
            "        .waitrequest_o({}), .readdatavalid_o({}), .readdata_o({}),\n        {}\n    "
            ");",
            m.width, i.port("readdatavalid") ? 1 : 0,
            is_set(i, "linewrapBursts") ? longest_burst(i, m.width) * m.width / 8 : 0, own.name,
            own.clock, own.reset,
            lower(i.property("addressUnits", "SYMBOLS")) == "words"
                ? fmt::format("{} * {}", from("address", "0"), m.width / 8)
                : from("address", "0"),
            from("read", "1'b0"), from("write", "1'b0"),
            from("byteenable", fmt::format("{{{}{{1'b1}}}}", m.width / 8)),
            from("writedata", fmt::format("{}'d0", m.width)),
            from("burstcount", "11'd1") +
                (in_symbols(i) ? fmt::format(" / {}", m.width / 8) : std::string{}),
            to("waitrequest"), to("readdatavalid"), to("readdata"), asks(own)));
        return own;
    }

    // Of AXI4-Lite and of what a master has not: bursts of one beat, as wide as its data.
    template <class From, class To>
    void axi_agent(const Master& m, const Bus& own, const From& from, const To& to) {
        const Interface& i = *m.end.interface;
        unsigned size = 0;
        while (8u << size < m.width) ++size;
        const std::string whole = fmt::format("3'd{}", size), one = "8'd0", up = "2'd1",
                          none = "1'b0", lanes = fmt::format("{{{}{{1'b1}}}}", m.width / 8);
        std::string ports;
        const auto input = [&](const char* role, const std::string& otherwise) {
            ports += fmt::format(" .{}_i({}),", role, from(role, otherwise));
        };
        for (const char* channel : {"aw", "ar"}) {
            const auto role = [&](const char* rest) { return std::string{channel} + rest; };
            ports += "\n       ";
            input(role("id").c_str(), none);
            input(role("addr").c_str(), "0");
            input(role("len").c_str(), one);
            input(role("size").c_str(), whole);
            input(role("burst").c_str(), up);
            input(role("valid").c_str(), none);
            ports += fmt::format(" .{0}ready_o({1}),", channel, to(role("ready").c_str()));
        }
        ports += "\n       ";
        input("wdata", fmt::format("{}'d0", m.width));
        input("wstrb", lanes);
        input("wvalid", none);
        input("bready", none);
        input("rready", none);
        for (const char* role : {"wready", "bid", "bvalid", "rid", "rlast"})
            ports += fmt::format(" .{}_o({}),", role, to(role));
        const Port* id = i.port("arid") ? i.port("arid") : i.port("awid");
        const Port* address = i.port("araddr") ? i.port("araddr") : i.port("awaddr");
        text_.line(
            fmt::format("de1sim_axi_master #(.WIDTH({}), .ADDRESS({}), .ID({})) {}_agent (\n"
                        "        .clk_i({}), .rst_i({}),{}\n"
                        "        .axi_rdata_o({}), .axi_rvalid_o({}),\n        {}\n    );",
                        m.width, address->width, id && id->width ? id->width : 1, own.name,
                        own.clock, own.reset, ports, to("rdata"), to("rvalid"), asks(own)));
    }

    void decode(const Bus& own, const std::vector<Link>& links, const std::vector<Bus>& ways) {
        const std::size_t count = links.size();
        for (const Bus& way : ways) connect_command(own, way);
        // Addresses are decoded up to the end of the highest slave; above they repeat.
        std::uint64_t end = 1;
        for (const Link& link : links)
            while (end < link.base + slaves()[link.slave].span) end *= 2;
        unsigned bits = 0;
        while (std::uint64_t{1} << bits < end) ++bits;
        if (const Master& m = map_.masters()[links.front().master]; m.is_bridge)
            out_.bridges.push_back(
                {window_of(m), end, slaves()[links[map_.default_of(links, false)].slave].end.name(),
                 slaves()[links[map_.default_of(links, true)].slave].end.name()});
        const std::string hit = own.name + "_hit";
        text_.wire(hit, static_cast<unsigned>(count));
        std::vector<std::string> inside;
        for (std::size_t n = 0; n < count; ++n) {
            const Slave& s = slaves()[links[n].slave];
            unsigned low = 0;
            while (std::uint64_t{1} << low < s.span) ++low;
            const std::string name = fmt::format("{}_in_{}", own.name, short_name(s.end));
            text_.wire(name, 1);
            std::string condition = "1'b1";
            if (low < bits)
                condition = fmt::format("{}_address[{}:{}] == {}'h{:x}", own.name, bits - 1, low,
                                        bits - low, links[n].base >> low);
            const std::string can = s.reads && s.writes ? ""
                                    : s.reads           ? fmt::format(" && !{}_write", own.name)
                                                        : fmt::format(" && {}_write", own.name);
            text_.line(fmt::format("assign {} = {}{};", name, condition, can));
            inside.push_back(name);
        }
        // An address of nobody goes to the largest slave that takes such an access.
        std::string others;
        for (const std::string& name : inside) others += (others.empty() ? "" : " || ") + name;
        const std::string nobody = own.name + "_nobody";
        text_.wire(nobody, 1);
        text_.line(fmt::format("assign {} = !({});", nobody, others));
        for (std::size_t n = 0; n < count; ++n) {
            std::string how;
            const bool reads = map_.default_of(links, false) == n,
                       writes = map_.default_of(links, true) == n;
            if (reads && writes)
                how = fmt::format(" || {}", nobody);
            else if (reads)
                how = fmt::format(" || ({} && !{}_write)", nobody, own.name);
            else if (writes)
                how = fmt::format(" || ({} && {}_write)", nobody, own.name);
            text_.line(fmt::format("assign {}{} = {}{};", hit,
                                   count > 1 ? fmt::format("[{}]", n) : "", inside[n], how));
        }
        const auto all = [&](const char* suffix) {
            std::string text;
            for (std::size_t n = count; n-- > 0;)
                text += (text.empty() ? "" : ", ") + ways[n].name + suffix;
            return "{" + text + "}";
        };
        text_.line(
            fmt::format("de1sim_avalon_decoder #(.SLAVES({0}), .WIDTH({1})) {2}_decoder (\n"
                        "        .clk_i({3}), .rst_i({4}),\n"
                        "        .valid_i({2}_valid), .ready_o({2}_ready), .count_i({2}_count),\n"
                        "        .hit_i({2}_hit),\n"
                        "        .rvalid_o({2}_rvalid), .rdata_o({2}_rdata),\n"
                        "        .valid_o({5}),\n        .ready_i({6}),\n        .rvalid_i({7}),\n"
                        "        .rdata_i({8})\n    );",
                        count, own.width, own.name, own.clock, own.reset, all("_valid"),
                        all("_ready"), all("_rvalid"), all("_rdata")));
    }

    Bus crossed(const Bus& way, const Slave& s) {
        const Assembly::Clock clock = assembly_.clock_of(s.end);
        const Bus to = bus(way.name + "_crossed", way.width, clock.wire, assembly_.reset_of(s.end));
        text_.line(fmt::format(
            "de1sim_avalon_crossing #(.WIDTH({0})) {1}_crossing (\n"
            "        .clk_i({2}), {3}, .count_i({1}_count),\n        .to_clk_i({4}), {5}\n    );",
            way.width, way.name, way.clock, way.is_asked(), to.clock, asks(to)));
        return to;
    }

    Bus fitted(const Bus& way, const Slave& s) {
        const Bus to = bus(way.name + "_fitted", s.width, way.clock, way.reset);
        text_.line(fmt::format(
            "de1sim_avalon_width #(.FROM({}), .TO({}), .BURSTS({})) {}_width (\n"
            "        .clk_i({}), .rst_i({}),\n        {},\n        .count_i({}_count), {}\n    );",
            way.width, s.width, longest_burst(*s.end.interface, s.width) > 1 ? 1 : 0, way.name,
            way.clock, way.reset, way.is_asked(), way.name, asks(to)));
        return to;
    }

    Bus arbitrated(const Slave& s, const std::vector<std::pair<Bus, unsigned>>& masters) {
        if (masters.size() == 1) return masters.front().first;
        const Bus to = bus("to_" + short_name(s.end), s.width, assembly_.clock_of(s.end).wire,
                           assembly_.reset_of(s.end));
        const auto all = [&](const char* suffix) {
            std::string text;
            for (std::size_t n = masters.size(); n-- > 0;)
                text += (text.empty() ? "" : ", ") + masters[n].first.name + suffix;
            return "{" + text + "}";
        };
        std::string shares;
        for (std::size_t n = masters.size(); n-- > 0;)
            shares += fmt::format("{}8'd{}", shares.empty() ? "" : ", ", masters[n].second);
        text_.line(fmt::format(
            "de1sim_avalon_arbiter #(.MASTERS({0}), .WIDTH({1}), .SHARES({{{2}}})) {3}_arbiter (\n"
            "        .clk_i({4}), .rst_i(1'b0),\n        .valid_i({5}),\n        .ready_o({6}),\n"
            "        .write_i({7}),\n        .count_i({8}),\n        .address_i({9}),\n"
            "        .wdata_i({10}),\n        .be_i({11}),\n        .rvalid_o({12}),\n"
            "        .valid_o({13}_valid), .ready_i({13}_ready), .write_o({13}_write),\n"
            "        .count_o({13}_count), .address_o({13}_address), .wdata_o({13}_wdata),\n"
            "        .be_o({13}_be), .rvalid_i({13}_rvalid)\n    );",
            masters.size(), s.width, shares, short_name(s.end), to.clock, all("_valid"),
            all("_ready"), all("_write"), all("_count"), all("_address"), all("_wdata"), all("_be"),
            all("_rvalid"), to.name));
        for (const auto& [way, n] : masters)
            text_.line(fmt::format("assign {}_rdata = {}_rdata;", way.name, to.name));
        return to;
    }

    const Assembly& assembly_;
    VerilogText& text_;
    const MemoryMap map_;
    Interconnect out_;
};

}  // namespace

Interconnect write_interconnect(const Assembly& assembly, VerilogText& text) {
    return Writer{assembly, text}.run();
}

}  // namespace sim::project::qsys
