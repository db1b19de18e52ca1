#include "sim/project/qsys/slave_agent.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace sim::project::qsys {

namespace {

// Of reads, as the interconnect holds them.  The vendor's lets a slave have one more than it says.
constexpr unsigned MOST_PENDING = 128;

class Agent {
public:
    Agent(const Assembly& assembly, VerilogText& text, const Slave& slave, const Bus& from,
          const std::string& name)
        : text_{text},
          slave_{slave},
          interface_{*slave.end.interface},
          from_{from},
          name_{name},
          clock_{assembly.clock_of(slave.end).wire},
          reset_{assembly.reset_of(slave.end)} {}

    void avalon() {
        const Interface& i = interface_;
        const unsigned burst = longest_burst(i, slave_.width);
        const unsigned pending = i.number("maximumPendingReadTransactions", 0);
        const std::string joined = name_ + "_burst";
        Bus bus = from_;
        if (burst > 1) {
            bus = joined_bus(joined, burst, pending);
            constant({{"burstcount",
                       fmt::format("{}_length{}", joined,
                                   in_symbols(i) ? fmt::format(" * {}", slave_.width / 8) : "")}});
        } else {
            constant(
                {{"burstcount", in_symbols(i) ? fmt::format("{}", slave_.width / 8) : "1'b1"}});
        }
        constant({{"clken", "1'b1"},
                  {"debugaccess", "1'b0"},
                  {"beginbursttransfer",
                   name_ + ".begintransfer_o" + (burst > 1 ? " && " + joined + "_first" : "")},
                  {"penable", fmt::format("{0}.read_o || {0}.write_o", name_)},  // APB
                  {"pwrite", bus.name + "_write"}});
        const bool waits = i.port("waitrequest") || i.port("waitrequest_n");
        const unsigned read_wait = i.number("readWaitTime", i.number("readWaitStates", 1)),
                       write_wait = i.number("writeWaitTime", i.number("writeWaitStates", 0));
        // A slave has one of byteenable and writebyteenable.
        const std::string bytes = i.port("byteenable") || i.port("byteenable_n")
                                      ? drive("byteenable")
                                      : drive("writebyteenable");
        text_.line(fmt::format(
            "de1sim_avalon_slave #(\n        .WIDTH({}), .ADDRESS({}), .SHIFT({}), .SETUP({}), "
            ".READ_WAIT({}), .WRITE_WAIT({}), .HOLD({}), .LATENCY({}),\n"
            "        .WAITREQUEST({}), .READDATAVALID({}), .READS({}), .WRITES({}),\n"
            "        .MOST({})\n    ) {} (\n"
            "        .clk_i({}), .rst_i({}),\n        {},\n        .length_i({}),\n"
            "        .address_o({}), .chipselect_o({}), .read_o({}), .write_o({}),\n"
            "        .begintransfer_o({}), .byteenable_o({}), .writedata_o({}),\n"
            "        .readdata_i({}), .waitrequest_i({}), .readdatavalid_i({})\n    );",
            slave_.width, std::max(1u, slave_.address_bits), slave_.shift, i.number("setupTime", 0),
            read_wait, write_wait, i.number("holdTime", 0), i.number("readLatency", 0),
            waits ? 1 : 0, i.port("readdatavalid") || i.port("readdatavalid_n") ? 1 : 0,
            slave_.reads ? 1 : 0, slave_.writes ? 1 : 0,
            burst > 1 || pending == 0 ? MOST_PENDING : std::min(pending + 1, MOST_PENDING), name_,
            clock_, reset_, bus.is_asked(), burst > 1 ? joined + "_length" : "12'd1",
            wire("address"), drive("chipselect"), drive("read"), drive("write"),
            drive("begintransfer"), bytes, wire("writedata"),
            output("readdata", fmt::format("{}'d0", slave_.width)), output("waitrequest", "1'b0"),
            output("readdatavalid", "1'b0")));
    }

    // The processor's memory: what a master asks of it is no signal of the design.
    void processor() {
        text_.line(fmt::format(
            "de1sim_hps_agent #(.PORT({}), .WIDTH({})) {} (\n        .clk_i({}), .rst_i({}),\n"
            "        {}\n    );",
            interface_.number("commandPort", 0), slave_.width, name_, clock_, reset_,
            from_.is_asked()));
    }

    // One transfer of one word at a time.
    void axi() {
        unsigned size = 0;
        while (8u << size < slave_.width) ++size;
        const std::string of_word = fmt::format("3'd{}", size);
        constant({{"awsize", of_word},
                  {"arsize", of_word},
                  {"awburst", "2'b01"},
                  {"arburst", "2'b01"},
                  {"wlast", "1'b1"}});
        const Port* of_id = nullptr;
        for (const char* role : {"awid", "wid", "bid", "arid", "rid"})
            if (!of_id) of_id = interface_.port(role);
        const std::string id = name_ + "_id";
        text_.wire(id, of_id ? std::max(1u, of_id->width) : 1);
        for (const char* role : {"awid", "wid", "arid"}) constant({{role, id}});
        for (const char* role :
             {"awlen", "awlock", "awcache", "awprot", "awqos", "awregion", "awuser", "wuser",
              "arlen", "arlock", "arcache", "arprot", "arqos", "arregion", "aruser"})
            constant({{role, "1'b0"}});
        text_.line(fmt::format(
            "de1sim_axi_slave #(.WIDTH({}), .ADDRESS({}), .ID({})) {} (\n"
            "        .clk_i({}), .rst_i({}),\n        {},\n"
            "        .awaddr_o({}), .awvalid_o({}), .awready_i({}),\n"
            "        .wdata_o({}), .wstrb_o({}), .wvalid_o({}), .wready_i({}),\n"
            "        .bvalid_i({}), .bready_o({}), .id_o({}), .bid_i({}), .rid_i({}),\n"
            "        .araddr_o({}), .arvalid_o({}), .arready_i({}),\n"
            "        .axi_rdata_i({}), .axi_rvalid_i({}), .axi_rready_o({})\n    );",
            slave_.width, std::max(1u, slave_.address_bits), of_id ? std::max(1u, of_id->width) : 1,
            name_, clock_, reset_, from_.is_asked(), wire("awaddr"), wire("awvalid"),
            output("awready", "1'b1"), wire("wdata"), wire("wstrb"), wire("wvalid"),
            output("wready", "1'b1"), output("bvalid", "1'b1"), wire("bready"), id,
            output("bid", id), output("rid", id), wire("araddr"), wire("arvalid"),
            output("arready", "1'b1"), output("rdata", fmt::format("{}'d0", slave_.width)),
            output("rvalid", "1'b1"), wire("rready")));
    }

private:
    // What the slave gets as bursts: of `most` words, with a slave's own number of pending reads.
    Bus joined_bus(const std::string& name, unsigned most, unsigned pending) {
        constexpr unsigned MOST_READS = 64;
        const Bus to{name, from_.width, clock_, reset_};
        for (const char* bit : {"_valid", "_ready", "_write", "_rvalid", "_first"})
            text_.wire(name + bit, 1);
        text_.wire(name + "_address", 32);
        text_.wire(name + "_length", 12);
        text_.wire(name + "_wdata", from_.width);
        text_.wire(name + "_rdata", from_.width);
        text_.wire(name + "_be", from_.width / 8, from_.width > 8);
        text_.line(fmt::format(
            "de1sim_avalon_burst #(.WIDTH({0}), .MAX({1}), .BOUNDARIES({2}), .WRAPS({3}), "
            ".READS({4}),\n        .PENDING({5})) {6} (\n"
            "        .clk_i({7}), .rst_i({8}),\n        {9}, .count_i({10}_count),\n"
            "        .valid_o({6}_valid), .ready_i({6}_ready), .write_o({6}_write),\n"
            "        .address_o({6}_address), .length_o({6}_length), .first_o({6}_first),\n"
            "        .wdata_o({6}_wdata), .be_o({6}_be), .rvalid_i({6}_rvalid),\n"
            "        .rdata_i({6}_rdata)\n    );",
            from_.width, most, is_set(interface_, "burstOnBurstBoundariesOnly") ? 1 : 0,
            is_set(interface_, "linewrapBursts") ? 1 : 0, slave_.reads ? 1 : 0,
            pending == 0 ? MOST_READS : std::min(pending + 1, MOST_READS), name, clock_, reset_,
            from_.is_asked(), from_.name));
        return to;
    }
    std::string wire(const char* role) const {
        const Port* port = interface_.port(role);
        return port ? slave_.end.wire(*port) : std::string{};
    }
    // An input of the slave, active high or low.
    std::string drive(const char* role) const {
        if (const Port* port = interface_.port(role)) return slave_.end.wire(*port);
        const Port* low = interface_.port(std::string{role} + "_n");
        if (!low) return {};
        const std::string high = slave_.end.wire(*low) + "_high";
        text_.wire(high, low->width, low->is_vector);
        text_.line(fmt::format("assign {} = ~{};", slave_.end.wire(*low), high));
        return high;
    }
    std::string output(const char* role, const std::string& otherwise) const {
        if (const Port* port = interface_.port(role)) return slave_.end.wire(*port);
        if (const Port* low = interface_.port(std::string{role} + "_n"))
            return "!" + slave_.end.wire(*low);
        return otherwise;
    }
    void constant(const std::vector<std::pair<const char*, std::string>>& roles) const {
        for (const auto& [role, value] : roles)
            if (const Port* port = interface_.port(role))
                text_.line(fmt::format("assign {} = {};", slave_.end.wire(*port), value));
    }

    VerilogText& text_;
    const Slave& slave_;
    const Interface& interface_;
    const Bus& from_;
    const std::string& name_;
    const std::string clock_, reset_;
};

}  // namespace

std::string Bus::is_asked() const {
    return fmt::format(
        ".valid_i({0}_valid), .ready_o({0}_ready), .write_i({0}_write),\n"
        "        .address_i({0}_address), .wdata_i({0}_wdata), .be_i({0}_be),\n"
        "        .rvalid_o({0}_rvalid), .rdata_o({0}_rdata)",
        name);
}

void write_slave_agent(const Assembly& assembly, VerilogText& text, const Slave& slave,
                       const Bus& from, const std::string& name, std::vector<std::string>& notes) {
    Agent agent{assembly, text, slave, from, name};
    if (slave.end.is_processors())
        agent.processor();
    else
        is_axi(*slave.end.interface) ? agent.axi() : agent.avalon();
    if (slave.end.interface->port("pslverr"))
        notes.push_back(
            fmt::format("{}: an error of {} by pslverr is not passed on to the processor",
                        assembly.system().file.filename().string(), slave.end.name()));
}

}  // namespace sim::project::qsys
