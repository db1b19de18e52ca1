// Masters in the FPGA on the processor's memory, by fpga2hps and fpga2sdram: random bursts of AXI3
// (ARM IHI 0022D) and of Avalon-MM, against a memory of bytes.

#include "Vhps_masters_bench.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <deque>
#include <optional>
#include <random>
#include <vector>

#include "sim/project/runtime/endings.h"
#include "sim/project/runtime/masters.h"
#include "tb/ip/random_master.h"
#include "tb/ip/wide_port.h"

namespace sim::project {
Evaluated evaluated;
void end_run(Ending::Kind, const std::string& message) { ADD_FAILURE() << message; }
}  // namespace sim::project

namespace {

using sim::project::ProcessorMemory;
using namespace sim::test;

static_assert(BRIDGE == ProcessorMemory::FPGA2HPS);

class Bytes final : public ProcessorMemory {
public:
    explicit Bytes(std::mt19937& random) : random_{random} {}
    bool is_open(unsigned) const override { return true; }
    bool takes(unsigned, std::uint64_t) const override { return random_() % 4; }
    std::uint64_t begin(unsigned, std::uint64_t now_ps) override {
        return now_ps + random_() % 100'000;
    }
    Answer access(unsigned, bool write, std::uint32_t address, std::uint8_t* data, unsigned bytes,
                  std::uint64_t) override {
        if (address >= NOBODY) return Answer::NOBODY;
        for (unsigned n = 0; n < bytes; ++n)
            write ? all[address + n] = data[n] : data[n] = all[address + n];
        return Answer::DONE;
    }
    std::vector<std::uint8_t> all = std::vector<std::uint8_t>(REGION * PORTS);

private:
    std::mt19937& random_;
};

// ---- The bench ----

// A master's place at fpga2sdram.  `reads`, `writes`: its command port; or NONE.
constexpr unsigned NONE = 9;
struct Place {
    bool is_axi;
    unsigned width;                                   // bytes
    unsigned reads, writes, first_read, first_write;  // command ports, data ports
};

class HpsMasters : public testing::Test {
protected:
    HpsMasters() {
        sim::project::set_processor_memory(&memory);
        for (std::uint8_t& byte : memory.all) byte = static_cast<std::uint8_t>(random());
    }

    void add_bridge(unsigned width) {
        top.size_i = width == 4 ? 0 : width == 8 ? 1 : 2;
        Wires w;
        w.command = [this](const Burst* burst) {
            top.awvalid_i = burst && burst->write;
            top.arvalid_i = burst && !burst->write;
            if (!burst) return;
            top.awaddr_i = top.araddr_i = burst->address;
            top.awlen_i = top.arlen_i = static_cast<CData>(burst->beats - 1);
            top.awsize_i = top.arsize_i = static_cast<CData>(burst->size);
            top.awburst_i = top.arburst_i = static_cast<CData>(burst->kind);
            top.awid_i = top.arid_i = burst->id;
        };
        w.command_ready = [this](bool write) { return write ? top.awready_o : top.arready_o; };
        w.data = [this](const Beat* beat, bool last) {
            top.wvalid_i = beat != nullptr;
            top.wlast_i = last;
            if (!beat) return;
            for (unsigned n = 0; n < 16; ++n) set(&top.wdata_i[0], 8 * n, 8, beat->data[n]);
            top.wstrb_i = static_cast<SData>(beat->strobes);
        };
        w.data_ready = [this] { return top.wready_o != 0; };
        w.take_reads = [this](bool take) { top.rready_i = take; };
        w.take_responses = [this](bool take) { top.bready_i = take; };
        w.read = [this]() -> std::optional<Wires::Read> {
            if (!top.rvalid_o) return {};
            Wires::Read read{{}, top.rid_o, top.rresp_o, top.rlast_o != 0};
            for (unsigned n = 0; n < 16; ++n)
                read.beat.data[n] = static_cast<std::uint8_t>(get(&top.rdata_o[0], 8 * n, 8));
            return read;
        };
        w.response = [this]() -> std::optional<Wires::Response> {
            if (!top.bvalid_o) return {};
            return Wires::Response{top.bid_o, top.bresp_o};
        };
        masters.emplace_back(w, ProcessorMemory::FPGA2HPS, width, true, true, true, random,
                             memory.all);
    }

    void configure(unsigned port, unsigned kind, const Place& place) {
        const unsigned width = place.width == 4    ? 0
                               : place.width == 8  ? 1
                               : place.width == 16 ? 2
                                                   : 3;
        top.cfg_axi_mm_select_i |= static_cast<CData>(place.is_axi << port);
        top.cfg_cport_type_i |= static_cast<SData>(kind << 2 * port);
        top.cfg_port_width_i =
            static_cast<SData>((top.cfg_port_width_i & ~(3u << 2 * port)) | width << 2 * port);
        for (unsigned n = 0; n < std::max(1u, place.width / 8); ++n) {
            if (kind & 2)
                top.cfg_rfifo_cport_map_i |= static_cast<SData>(port << 4 * (place.first_read + n));
            if (kind & 1)
                top.cfg_wfifo_cport_map_i |=
                    static_cast<SData>(port << 4 * (place.first_write + n));
        }
        if (kind & 2) top.cfg_cport_rfifo_map_i |= place.first_read << 3 * port;
        if (kind & 1) top.cfg_cport_wfifo_map_i |= place.first_write << 3 * port;
    }

    void add(const Place& p) {
        if (p.reads == p.writes) {
            configure(p.reads, 3, p);
        } else {
            if (p.reads != NONE) configure(p.reads, 2, p);
            if (p.writes != NONE) configure(p.writes, 1, p);
        }
        const unsigned lanes = std::max(1u, p.width / 8), bytes = std::min(8u, p.width);
        Wires w;
        w.command = [this, p](const Burst* burst) {
            for (const unsigned port : {p.reads, p.writes})
                if (port != NONE) top.cmd_valid_i &= static_cast<CData>(~(1u << port));
            if (!burst) return;
            const unsigned port = burst->write ? p.writes : p.reads;
            top.cmd_valid_i |= static_cast<CData>(1u << port);
            EData* data = &top.cmd_data_i[0];
            const unsigned at = 60 * port;
            set(data, at, 60, 0);
            set(data, at + (burst->write ? 1 : 0), 1, 1);
            if (!p.is_axi) {
                set(data, at + 2, 30, burst->address / p.width);
                set(data, at + 34, 8, burst->beats);
                return;
            }
            set(data, at + 3, 32, burst->address);
            set(data, at + 35, 4, burst->beats - 1);
            set(data, at + 43, 8, burst->id);
            set(data, at + 51, 3, burst->size);
            set(data, at + 54, 2, burst->kind);
        };
        w.command_ready = [this, p](bool write) {
            return (top.cmd_ready_o >> (write ? p.writes : p.reads) & 1) != 0;
        };
        w.data = [this, p, lanes, bytes](const Beat* beat, bool last) {
            for (unsigned n = 0; n < lanes && p.writes != NONE; ++n) {
                const unsigned port = p.first_write + n, at = 90 * port;
                top.wr_valid_i &= static_cast<CData>(~(1u << port));
                if (!beat) continue;
                if (p.is_axi) top.wr_valid_i |= static_cast<CData>(1u << port);
                EData* data = &top.wr_data_i[0];
                set(data, at, 90, 0);
                for (unsigned b = 0; b < bytes; ++b)
                    set(data, at + 8 * b, 8, beat->data[8 * n + b]);
                set(data, at + (p.is_axi ? 64 : 80), 8, beat->strobes >> 8 * n & 0xFF);
                if (p.is_axi) set(data, at + 72, 1, last);
            }
        };
        w.data_ready = [this, p] { return (top.wr_ready_o >> p.first_write & 1) != 0; };
        w.take_reads = [this, p, lanes](bool take) {
            for (unsigned n = 0; n < lanes && p.reads != NONE; ++n) {
                const auto bit = static_cast<CData>(1u << (p.first_read + n));
                take ? top.rd_ready_i |= bit : top.rd_ready_i &= static_cast<CData>(~bit);
            }
        };
        w.take_responses = [this, p](bool take) {
            if (p.writes == NONE) return;
            const auto bit = static_cast<CData>(1u << p.writes);
            take ? top.wrack_ready_i |= bit : top.wrack_ready_i &= static_cast<CData>(~bit);
        };
        w.read = [this, p, lanes, bytes]() -> std::optional<Wires::Read> {
            const unsigned all = ((1u << lanes) - 1) << p.first_read;
            if (p.reads == NONE || !(top.rd_valid_o & all)) return {};
            EXPECT_EQ(top.rd_valid_o & all, all);
            const EData* data = &top.rd_data_o[0];
            const unsigned end = 80 * (p.first_read + lanes - 1) + 64;
            Wires::Read read{{},
                             static_cast<unsigned>(get(data, end + 3, 8)),
                             static_cast<unsigned>(get(data, end, 2)),
                             get(data, end + 2, 1) != 0};
            for (unsigned n = 0; n < lanes; ++n)
                for (unsigned b = 0; b < bytes; ++b)
                    read.beat.data[8 * n + b] =
                        static_cast<std::uint8_t>(get(data, 80 * (p.first_read + n) + 8 * b, 8));
            return read;
        };
        w.response = [this, p]() -> std::optional<Wires::Response> {
            if (p.writes == NONE || !(top.wrack_valid_o >> p.writes & 1)) return {};
            const std::uint64_t answer = top.wrack_data_o >> 10 * p.writes & 0x3FF;
            return Wires::Response{static_cast<unsigned>(answer >> 2),
                                   static_cast<unsigned>(answer & 3)};
        };
        const unsigned region = p.reads != NONE ? p.reads : p.writes;
        masters.emplace_back(w, region, p.width, p.is_axi, p.reads != NONE, p.writes != NONE,
                             random, memory.all);
    }

    // Until each has moved that many words.
    void play(std::uint64_t beats) {
        const auto least = [this] {
            return std::min_element(masters.begin(), masters.end(),
                                    [](auto& a, auto& b) { return a.beats() < b.beats(); })
                ->beats();
        };
        std::uint64_t before = 0;
        while (least() < beats && !HasFatalFailure()) {
            for (unsigned clocks = 0; clocks < 2000; ++clocks) {
                for (Master& master : masters) master.drive();
                top.clk_i = 0;
                top.eval();
                for (Master& master : masters) master.look();
                top.clk_i = 1;
                sim::project::evaluated.time_ps += 10'000;
                top.eval();
            }
            ASSERT_GT(least(), before) << "a master that is not served";
            before = least();
        }
    }

    std::mt19937 random{1};
    Bytes memory{random};
    Vhps_masters_bench top;
    std::deque<Master> masters;
};

constexpr std::uint64_t BEATS = 60'000;  // a million of all masters

TEST_F(HpsMasters, BridgeOf32Bits) { add_bridge(4), play(BEATS); }
TEST_F(HpsMasters, BridgeOf64Bits) { add_bridge(8), play(BEATS); }
TEST_F(HpsMasters, BridgeOf128Bits) { add_bridge(16), play(BEATS); }

TEST_F(HpsMasters, AvalonPortOf32Bits) { add({false, 4, 0, 0, 0, 0}), play(BEATS); }
TEST_F(HpsMasters, AvalonPortOf256Bits) { add({false, 32, 0, 0, 0, 0}), play(BEATS); }

TEST_F(HpsMasters, ThreeAvalonPortsBesideTheBridge) {
    add({false, 16, 0, 0, 0, 0});
    add({false, 8, 1, 1, 2, 2});
    add({false, 8, 2, 2, 3, 3});
    add_bridge(8);
    play(BEATS);
}

TEST_F(HpsMasters, AvalonPortsThatReadOrWriteAlone) {
    add({false, 8, 0, NONE, 0, 0});
    add({false, 8, NONE, 1, 0, 0});
    add({false, 16, 2, NONE, 1, 0});
    add({false, 16, NONE, 3, 0, 2});
    play(BEATS);
}

TEST_F(HpsMasters, AxiPortsOf32And64And128Bits) {
    add({true, 4, 0, 1, 0, 0});
    add({true, 8, 2, 3, 1, 1});
    add({true, 16, 4, 5, 2, 2});
    play(BEATS);
}

TEST_F(HpsMasters, AxiPortOf256Bits) { add({true, 32, 0, 1, 0, 0}), play(BEATS); }

}  // namespace
