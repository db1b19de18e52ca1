#include "sim/project/qsys/interconnect.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "sim/project/qsys/slave_agent.h"
#include "sim/text/lower.h"

namespace sim::project::qsys {

namespace {

constexpr const char* FULL_MASTER = "h2f_axi_master";
constexpr unsigned WIDEST = 1024, NATIVE = 32;  // bits of data
constexpr unsigned DEEPEST = 20;                // bridges behind each other

struct Master {
    End end;
    unsigned width;
    std::string clock;
    bool is_bridge;  // of the processor
};

struct Link {
    std::size_t master, slave;
    std::uint64_t base;
    unsigned shares;
};

class Writer {
public:
    Writer(const Assembly& assembly, VerilogText& text) : assembly_{assembly}, text_{text} {}

    Interconnect run() {
        masters_and_slaves();
        interconnect();
        return std::move(out_);
    }

private:
    // ---- Who is connected to whom ----

    void masters_and_slaves() {
        std::map<std::string, std::size_t> masters, slaves;
        std::map<std::string, std::string> unreached;  // masters by the processor's slave
        for (const Connection& c : assembly_.connections()) {
            if (c.kind != Connection::Kind::AVALON) continue;
            const End m = assembly_.end(c.start), s = assembly_.end(c.end);
            if (s.is_processors()) {
                std::string& names = unreached[c.end];
                names += (names.empty() ? "" : ", ") + c.start;
                continue;
            }
            if (!masters.count(c.start)) {
                masters[c.start] = masters_.size();
                masters_.push_back(master(m));
            }
            if (!slaves.count(c.end)) {
                slaves[c.end] = slaves_.size();
                slaves_.push_back(slave(s));
            }
            links_.push_back({masters[c.start], slaves[c.end], c.base, c.shares});
        }
        for (const auto& [slave, names] : unreached)
            out_.notes.push_back(
                fmt::format("{}: the processor's memory by {} is not simulated yet, for {}",
                            assembly_.system().file.filename().string(), slave, names));
        for (std::size_t n = 0; n < masters_.size(); ++n) check_addresses(n);
        for (std::size_t n = 0; n < masters_.size(); ++n)
            map_of(masters_[n], links_of(n), 0, std::uint64_t{1} << 32);
    }

    Master master(const End& e) {
        const Assembly::Clock clock = assembly_.clock_of(e);
        if (e.is_processors()) {
            return {e, e.interface->number("dataWidth", 32), clock.root, true};
        }
        if (e.interface->type != "avalon")
            assembly_.fail(
                fmt::format("the master {} is of type {}, which is not simulated: "
                            "expected avalon",
                            e.name(), e.interface->type));
        const Port* data = e.interface->port("readdata");
        if (!data) data = e.interface->port("writedata");
        if (!data || !e.interface->port("address"))
            assembly_.fail(fmt::format("the master {} has no address, or no data", e.name()));
        return {e, data->width, clock.root, false};
    }

    Slave slave(const End& e) {
        const bool axi = is_axi(*e.interface);
        if (!axi && e.interface->type != "avalon")
            assembly_.fail(
                fmt::format("the slave {} is of type {}, which is not simulated: "
                            "expected avalon, apb, axi, axi4 or axi4lite",
                            e.name(), e.interface->type));
        const Port* read = e.interface->port(axi ? "rdata" : "readdata");
        const Port* write = e.interface->port(axi ? "wdata" : "writedata");
        const Port* address = e.interface->port(!axi ? "address" : write ? "awaddr" : "araddr");
        if (!read && !write) assembly_.fail(fmt::format("the slave {} has no data", e.name()));
        Slave s{e,
                (read ? read : write)->width,
                address ? address->width : 0,
                0,
                0,
                read != nullptr,
                write != nullptr,
                assembly_.clock_of(e).root};
        // Each word of a slave that is aligned so has a word of 32 bits of its own.
        if (lower(e.interface->property("addressAlignment")) == "native")
            s.width = std::max(s.width, NATIVE);
        const std::uint64_t bytes = s.width / 8;
        if (s.width % 8 || (s.width & (s.width - 1)) || s.width > WIDEST)
            assembly_.fail(fmt::format("the slave {} has {} bits of data, expected 8, 16, ... 1024",
                                       e.name(), s.width));
        if (!axi && lower(e.interface->property("addressUnits", "WORDS")) != "symbols")
            while (1u << s.shift < bytes) ++s.shift;
        s.span = e.interface->number("explicitAddressSpan", 0);
        if (s.span == 0) s.span = (std::uint64_t{1} << s.address_bits) << s.shift;
        std::uint64_t whole = bytes;
        while (whole < s.span) whole *= 2;
        s.span = whole;
        return s;
    }

    std::vector<Link> links_of(std::size_t master) const {
        std::vector<Link> all;
        for (const Link& link : links_)
            if (link.master == master) all.push_back(link);
        std::sort(all.begin(), all.end(),
                  [](const Link& a, const Link& b) { return a.base < b.base; });
        return all;
    }

    void check_addresses(std::size_t master) {
        const std::vector<Link> all = links_of(master);
        for (std::size_t n = 0; n < all.size(); ++n) {
            const Slave& s = slaves_[all[n].slave];
            if (all[n].base % s.span)
                assembly_.fail(fmt::format("{} is at 0x{:x}, which is no multiple of its {} bytes",
                                           s.end.name(), all[n].base, s.span));
            if (n && all[n - 1].base + slaves_[all[n - 1].slave].span > all[n].base)
                assembly_.fail(
                    fmt::format("{} and {} have the same addresses of {}, from 0x{:x} on",
                                slaves_[all[n - 1].slave].end.name(), s.end.name(),
                                masters_[master].end.name(), all[n].base));
        }
    }

    // What `master` reaches, also through bridges, from `base` on.
    void map_of(const Master& master, const std::vector<Link>& links, std::uint64_t base,
                std::uint64_t end, unsigned depth = 0) {
        for (const Link& link : links) {
            const Slave& s = slaves_[link.slave];
            const std::uint64_t first = base + link.base;
            if (first >= end) continue;
            const std::string through = s.end.interface->property("bridgesToMaster");
            const std::string after = s.end.instance->name + "." + through;
            const auto next = std::find_if(masters_.begin(), masters_.end(),
                                           [&](const Master& m) { return m.end.name() == after; });
            if (through.empty() || next == masters_.end() || depth == DEEPEST)
                out_.map.push_back({master.end.name(), s.end.name(), first, s.span, s.reads,
                                    s.writes, window_of(master)});
            else
                map_of(master, links_of(static_cast<std::size_t>(next - masters_.begin())), first,
                       std::min(end, first + s.span), depth + 1);
        }
    }

    static std::uint32_t window_of(const Master& m) {
        if (!m.is_bridge) return 0;
        return m.end.interface->name == FULL_MASTER ? H2F_BASE : LW_BASE;
    }

    // ---- The pieces ----

    Bus bus(const std::string& name, unsigned width, const std::string& clock,
            const std::string& reset) {
        for (const char* bit : {"_valid", "_ready", "_write", "_rvalid"}) text_.wire(name + bit, 1);
        text_.wire(name + "_address", 32);
        text_.wire(name + "_wdata", width);
        text_.wire(name + "_rdata", width);
        text_.wire(name + "_be", width / 8, width > 8);
        return {name, width, clock, reset};
    }
    // The connections of a bus to a module's ports: as the one who asks, or who is asked.
    static std::string asks(const Bus& b) {
        return fmt::format(
            ".valid_o({0}_valid), .ready_i({0}_ready), .write_o({0}_write),\n"
            "        .address_o({0}_address), .wdata_o({0}_wdata), .be_o({0}_be),\n"
            "        .rvalid_i({0}_rvalid), .rdata_i({0}_rdata)",
            b.name);
    }
    void connect_command(const Bus& from, const Bus& to) {
        for (const char* wire : {"_write", "_address", "_wdata", "_be"})
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
        std::vector<std::vector<std::pair<Bus, unsigned>>> asked(slaves_.size());
        for (std::size_t m = 0; m < masters_.size(); ++m) {
            const std::vector<Link> links = links_of(m);
            text_.section("From " + masters_[m].end.name());
            const Bus own = agent_of(masters_[m]);
            std::vector<Bus> ways;
            for (const Link& link : links)
                ways.push_back(bus(fmt::format("{}_to_{}", short_name(masters_[m].end),
                                               short_name(slaves_[link.slave].end)),
                                   own.width, own.clock, own.reset));
            decode(own, links, ways);
            for (std::size_t n = 0; n < links.size(); ++n) {
                const Slave& s = slaves_[links[n].slave];
                Bus way = ways[n];
                if (masters_[m].clock != s.clock) way = crossed(way, s);
                if (way.width != s.width) way = fitted(way, s);
                asked[links[n].slave].emplace_back(way, links[n].shares);
            }
        }
        for (std::size_t n = 0; n < slaves_.size(); ++n) {
            text_.section("To " + slaves_[n].end.name());
            write_slave_agent(assembly_, text_, slaves_[n], arbitrated(slaves_[n], asked[n]),
                              short_name(slaves_[n].end) + "_agent", out_.notes);
        }
    }

    Bus agent_of(const Master& m) {
        const Assembly::Clock clock = assembly_.clock_of(m.end);
        const Bus own = bus("from_" + short_name(m.end), m.width, clock.wire,
                            m.is_bridge ? "1'b0" : assembly_.reset_of(m.end));
        if (m.is_bridge) {
            text_.line(
                fmt::format("de1sim_hps_bridge #(.FULL({}), .WIDTH({})) {}_agent (\n"
                            "        .clk_i({}),\n        {}\n    );",
                            m.end.interface->name == FULL_MASTER ? 1 : 0, m.width, own.name,
                            own.clock, asks(own)));
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
        text_.line(fmt::format(
            "de1sim_avalon_master #(.WIDTH({}), .READDATAVALID({})) {}_agent (\n"
            "        .clk_i({}), .rst_i({}),\n        .address_i({}), .read_i({}), .write_i({}),\n"
            "        .byteenable_i({}), .writedata_i({}), .burstcount_i({}),\n"
            "        .waitrequest_o({}), .readdatavalid_o({}), .readdata_o({}),\n        {}\n    "
            ");",
            m.width, i.port("readdatavalid") ? 1 : 0, own.name, own.clock, own.reset,
            lower(i.property("addressUnits", "SYMBOLS")) == "words"
                ? fmt::format("{} * {}", from("address", "0"), m.width / 8)
                : from("address", "0"),
            from("read", "1'b0"), from("write", "1'b0"),
            from("byteenable", fmt::format("{{{}{{1'b1}}}}", m.width / 8)),
            from("writedata", fmt::format("{}'d0", m.width)), from("burstcount", "11'd1"),
            to("waitrequest"), to("readdatavalid"), to("readdata"), asks(own)));
        return own;
    }

    void decode(const Bus& own, const std::vector<Link>& links, const std::vector<Bus>& ways) {
        const std::size_t count = links.size();
        for (const Bus& way : ways) connect_command(own, way);
        // Addresses are decoded up to the end of the highest slave; above they repeat.
        std::uint64_t end = 1;
        for (const Link& link : links)
            while (end < link.base + slaves_[link.slave].span) end *= 2;
        unsigned bits = 0;
        while (std::uint64_t{1} << bits < end) ++bits;
        if (const Master& m = masters_[links.front().master]; m.is_bridge)
            out_.bridges.push_back({window_of(m), m.width, end,
                                    slaves_[links[default_of(links, false)].slave].end.name(),
                                    slaves_[links[default_of(links, true)].slave].end.name()});
        const std::string hit = own.name + "_hit";
        text_.wire(hit, static_cast<unsigned>(count));
        std::vector<std::string> inside;
        for (std::size_t n = 0; n < count; ++n) {
            const Slave& s = slaves_[links[n].slave];
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
            const bool reads = default_of(links, false) == n, writes = default_of(links, true) == n;
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
                        "        .valid_i({2}_valid), .ready_o({2}_ready), .hit_i({2}_hit),\n"
                        "        .rvalid_o({2}_rvalid), .rdata_o({2}_rdata),\n"
                        "        .valid_o({5}),\n        .ready_i({6}),\n        .rvalid_i({7}),\n"
                        "        .rdata_i({8})\n    );",
                        count, own.width, own.name, own.clock, own.reset, all("_valid"),
                        all("_ready"), all("_rvalid"), all("_rdata")));
    }

    std::size_t default_of(const std::vector<Link>& links, bool write) const {
        std::size_t best = links.size(), largest = 0;
        for (std::size_t n = 0; n < links.size(); ++n) {
            const Slave& s = slaves_[links[n].slave];
            if (s.span > slaves_[links[largest].slave].span) largest = n;
            if (!(write ? s.writes : s.reads)) continue;
            if (best == links.size() || s.span > slaves_[links[best].slave].span) best = n;
        }
        return best == links.size() ? largest : best;  // who then must answer
    }

    Bus crossed(const Bus& way, const Slave& s) {
        const Assembly::Clock clock = assembly_.clock_of(s.end);
        const Bus to = bus(way.name + "_crossed", way.width, clock.wire, assembly_.reset_of(s.end));
        text_.line(
            fmt::format("de1sim_avalon_crossing #(.WIDTH({})) {}_crossing (\n"
                        "        .clk_i({}), {},\n        .to_clk_i({}), {}\n    );",
                        way.width, way.name, way.clock, way.is_asked(), to.clock, asks(to)));
        return to;
    }

    Bus fitted(const Bus& way, const Slave& s) {
        const Bus to = bus(way.name + "_fitted", s.width, way.clock, way.reset);
        text_.line(fmt::format(
            "de1sim_avalon_width #(.FROM({}), .TO({})) {}_width (\n"
            "        .clk_i({}), .rst_i({}),\n        {},\n        {}\n    );",
            way.width, s.width, way.name, way.clock, way.reset, way.is_asked(), asks(to)));
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
            "        .write_i({7}),\n        .address_i({8}),\n        .wdata_i({9}),\n"
            "        .be_i({10}),\n        .rvalid_o({11}),\n"
            "        .valid_o({12}_valid), .ready_i({12}_ready), .write_o({12}_write),\n"
            "        .address_o({12}_address), .wdata_o({12}_wdata), .be_o({12}_be),\n"
            "        .rvalid_i({12}_rvalid)\n    );",
            masters.size(), s.width, shares, short_name(s.end), to.clock, all("_valid"),
            all("_ready"), all("_write"), all("_address"), all("_wdata"), all("_be"),
            all("_rvalid"), to.name));
        for (const auto& [way, n] : masters)
            text_.line(fmt::format("assign {}_rdata = {}_rdata;", way.name, to.name));
        return to;
    }

    const Assembly& assembly_;
    VerilogText& text_;
    Interconnect out_;
    std::vector<Master> masters_;
    std::vector<Slave> slaves_;
    std::vector<Link> links_;
};

}  // namespace

Interconnect write_interconnect(const Assembly& assembly, VerilogText& text) {
    return Writer{assembly, text}.run();
}

}  // namespace sim::project::qsys
